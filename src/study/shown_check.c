/* SPDX-License-Identifier: MIT */
#include "study/shown_check.h"

#include "draw/words.h"
#include "scene/what.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* "4.2 mm/s" */
static void shown_number(char *text, size_t size, double value, double largest, const char *unit) {
    static const char *const small[] = {"", "m", "µ", "n"}, *const large[] = {"", "k", "M", "G"};
    int k = 0;
    bool prefix = strcmp(unit, "m") == 0 || strcmp(unit, "m/s") == 0 || unit[0] == 'N' || unit[0] == 'W' ||
                  strcmp(unit, "s") == 0;
    while (prefix && k > -3 && largest != 0 && largest < 0.1) k--, largest *= 1e3, value *= 1e3;
    while (prefix && k < 3 && largest >= 1e4) k++, largest /= 1e3, value /= 1e3;
    const char *square = strstr(unit, "^2");
    int length = square ? (int)(square - unit) : (int)strlen(unit);
    bool apart = *unit && strcmp(unit, "°") != 0;
    snprintf(text, size, "%s%.4g%s%s%.*s%s", value < 0 ? "−" : "", fabs(value), apart ? " " : "",
             k < 0 ? small[-k] : large[k], length, unit, square ? "²" : "");
}

tr_show_check tr_run_shown_check(const tr_check_result *r, const tr_scene *scene, bool several) {
    static const char *const symbol[TR_N_WHATS] = {[TR_SLIDING_VELOCITY] = "V_s", [TR_ROLLING_VELOCITY] = "V_r"};
#define ROW(choice, name, dim, unit, whose, when, function) [choice] = TR_WORD_what_##function,
    static const tr_word_key word[TR_N_WHATS] = {TR_WHATS(ROW)};
#undef ROW
    char part[TR_BY_SHAPE];
    tr_show_check shown = {.ok = r->ok};
    double scale = 1, measured = r->measured, exact = r->check->exact;
    const char *what = scene->output.view == TR_VIEW_EXPERT ? symbol[r->check->what] : NULL,
               *unit = tr_param_by_shape(r->unit, r->shape, part);
    if (strcmp(unit, "rad") == 0) unit = "°", scale = 180 / M_PI;
    if (strcmp(unit, "1") == 0) unit = "";
    if (strcmp(unit, "N/s") == 0) unit = "W/m";
    if (strcmp(unit, "J/s") == 0) unit = "W";
    if (fabs(measured) < 0.01 * r->check->tolerance) measured = 0; /* rounding */
    snprintf(shown.group, sizeof shown.group, "%s", several ? r->lane : "");
    int used = snprintf(shown.what, sizeof shown.what, "%.40s",
                        what ? what : tr_words_of((tr_language)scene->language, word[r->check->what]));
    if (scene->n_disks > 1) used += snprintf(shown.what + used, sizeof shown.what - (size_t)used, ", %.9s", r->of);
    if (r->check->at > 0 && r->check->at < scene->time_end)
        snprintf(shown.what + used, sizeof shown.what - (size_t)used, ", %.3g s", r->check->at);
    double largest = fmax(fabs(measured), fabs(exact)) * scale;
    shown_number(shown.measured, sizeof shown.measured, measured * scale, largest, unit);
    shown_number(shown.exact, sizeof shown.exact, exact * scale, largest, unit);
    if (isnan(r->measured)) snprintf(shown.measured, sizeof shown.measured, "never");
    return shown;
}

void tr_run_say_check(tr_run_report *report, const tr_check_result *r, bool several) {
    char number[48], off[32] = "", part[TR_BY_SHAPE];
    const char *unit = tr_param_by_shape(r->unit, r->shape, part);
    if (strcmp(unit, "1") == 0) unit = "";
    double exact = r->check->exact, error = r->measured - exact;
    snprintf(number, sizeof number, isnan(r->measured) ? "never happened" : "%.5g%s%s", r->measured, *unit ? " " : "",
             unit);
    if (!isnan(error)) snprintf(off, sizeof off, "error %.1e, ", error);
    tr_run_say(report, r->what, "%s%s%s: %s, exact %.5g%s%s, %sallowed %.1e: %s", r->of, several ? ", " : "",
               several ? r->lane : "", number, exact, *unit ? " " : "", unit, off, r->check->tolerance,
               r->ok ? "ok" : "FAILED");
    if (!r->ok) report->failed++;
}
