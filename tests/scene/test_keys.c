/* SPDX-License-Identifier: MIT */
/* `trundle run --keys` against what the reader and the writer of cases do: neither knows of those tables. */
#include "assert_close.h"
#include "base/param.h"
#include "laws/law.h"
#include "scene/keys.h"
#include "scene/scene.h"
#include "scene/write.h"
#include <glob.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { LINE = 2000 };
static const char *const kinds[] = {"biaxial", "bodies", "contact", "patch"};

static char *keys_of(const char *kind) {
    tr_status st = {0};
    char *text = tr_scene_keys(kind, tr_laws_catalog(), &st);
    if (!text) fail_msg("%s", st.text);
    return text;
}

/* The next line of *text, without its end; false: there is none. */
static bool next_line(const char **text, char line[LINE]) {
    if (!**text) return false;
    size_t n = strcspn(*text, "\n");
    assert_true(n < LINE);
    memcpy(line, *text, n);
    line[n] = '\0';
    *text += n + ((*text)[n] == '\n');
    return true;
}

/* "`word` ..." -> word */
static bool quoted(const char *text, char word[64]) {
    return sscanf(text, "`%63[^`]`", word) == 1;
}

/* A table of this heading ("" stands for the top) has a row of this key. */
static bool has_row(const char *text, const char *section, const char *key) {
    char line[LINE], word[64], here[64] = "?";
    while (next_line(&text, line)) {
        if (strncmp(line, "### ", 4) == 0 && !quoted(line + 4, here)) here[0] = '\0';
        if (strncmp(line, "| `", 3) == 0 && strcmp(here, section) == 0 && quoted(line + 2, word) && !strcmp(word, key))
            return true;
    }
    return false;
}

static bool has_law_row(const char *text, const char *key) {
    return has_row(text, "normal", key) || has_row(text, "friction", key) || has_row(text, "rolling", key);
}

/* Every key of a case as the writer writes it. Returns how many there were. */
static int find_written(const char *resolved, const char *path) {
    char line[LINE], kind[64] = "", section[64] = "", inner[64] = "", key[64];
    char *keys = NULL;
    int n = 0;
    while (next_line(&resolved, line)) {
        bool inside = line[0] == ' ';
        if (strcmp(line, "---") == 0) section[0] = kind[0] = '\0';
        if (sscanf(line, inside ? "%*[- ]%63[^:]:" : "%63[^:]:", key) != 1 || strchr("#-", *line)) continue;
        if (!inside && sscanf(line, "kind: %63s", kind) == 1) {
            free(keys);
            keys = keys_of(kind);
        }
        assert_non_null(keys);
        const char *after = strchr(line, ':') + 1;
        bool begins = !inside && (!*after || strncmp(after, " #", 2) == 0);
        if (!inside) snprintf(section, sizeof section, "%s", begins ? key : "");
        if (begins) continue;
        n++;
        bool deep = strncmp(line, "      ", 6) == 0; /* in a mapping of an item of a list */
        if (!deep) snprintf(inner, sizeof inner, "%s", *after ? "" : key);
        const char *section_of = deep ? inner : section;
        if (!inside && strstr(after, "\"/")) continue; /* path: FILE.csv */
        bool laws = strcmp(section_of, "contact") == 0 || strcmp(section_of, "laws") == 0;
        if (!has_row(keys, section_of, key) && !(laws && has_law_row(keys, key)))
            fail_msg("%s: `%s` of `%s` of kind %s is in no table", path, key, section_of, kind);
    }
    free(keys);
    return n;
}

static void every_key_of_every_shipped_case_is_in_the_table(void **state) {
    (void)state;
    glob_t found;
    assert_int_equal(glob("cases/*.yaml", 0, NULL, &found), 0);
    int n = 0, cases = 0;
    for (size_t i = 0; i < found.gl_pathc; i++) {
        tr_status st = {0};
        tr_scene scene;
        if (strstr(found.gl_pathv[i], "sweep")) continue; /* not a case: it names one */
        if (!tr_scene_read_file(&scene, found.gl_pathv[i], NULL, 0, tr_laws_catalog(), &st)) fail_msg("%s", st.text);
        char *text = tr_scene_write(&scene, tr_laws_catalog(), &st);
        assert_non_null(text);
        n += find_written(text, found.gl_pathv[i]);
        cases++;
        free(text);
        tr_scene_free(&scene);
    }
    globfree(&found);
    assert_true(cases > 20);
    assert_true(n > 20 * cases); /* the least case, of a contact, has more keys */
}

static void every_parameter_of_every_law_is_in_the_table(void **state) {
    (void)state;
    const tr_param_catalog *c = tr_laws_catalog();
    char *all = keys_of(NULL);
    const struct {
        const char *name;
        const tr_param_table *const *laws;
        int n;
    } slots[] = {
        {"normal", c->normal, c->n_normal},
        {"friction", c->friction, c->n_friction},
        {"rolling", c->rolling, c->n_rolling},
    };
    for (int s = 0; s < 3; s++)
        for (int i = 0; i < slots[s].n; i++)
            for (int k = 0; k < slots[s].laws[i]->n; k++) {
                const tr_param *p = &slots[s].laws[i]->params[k];
                if (!has_row(all, slots[s].name, p->key)) fail_msg("%s of %s", p->key, slots[s].laws[i]->name);
            }
    free(all);
}

/* The message of a case of this kind in which one section has this key and nothing else. what: for checks, or "". */
static void ask_reader(const char *kind, const char *section, const char *key, const char *what, tr_status *st) {
    char text[600], item[200];
    const char *needed[][2] = {{"bodies", "disks"}, {"contact", "laws"}, {"contact", "path"}, {"patch", "path"}};
    const char *lists = "disks walls checks laws path";
    int n = snprintf(text, sizeof text, "kind: %s\n", kind);
    for (int i = 0; i < 4; i++)
        if (!strcmp(needed[i][0], kind) && strcmp(needed[i][1], section) != 0)
            n += snprintf(text + n, sizeof text - (size_t)n, "%s: [{}]\n", needed[i][1]);
    snprintf(item, sizeof item, "{%s%s%s%s: 1}", *what ? "what: " : "", what, *what ? ", " : "", key);
    if (!*section)
        snprintf(text + n, sizeof text - (size_t)n, "%s: 1\n", key);
    else if (!strcmp(section, "pull"))
        snprintf(text + n, sizeof text - (size_t)n, "disks: [{pull: %s}]\n", item);
    else
        snprintf(text + n, sizeof text - (size_t)n, strstr(lists, section) ? "%s: [%s]\n" : "%s: %s\n", section, item);
    tr_scene scene;
    *st = (tr_status){0};
    if (tr_scene_read(&scene, &(tr_scene_source){"case.yaml", text, strlen(text), NULL, 0}, tr_laws_catalog(), st))
        tr_scene_free(&scene);
}

/* A row says whether its key can be given; the reader is asked about each. */
static void the_reader_takes_every_key_of_the_tables(void **state) {
    (void)state;
    int n = 0;
    for (int i = 0; i < 4; i++) {
        char *keys = keys_of(kinds[i]), line[LINE], key[64], section[64] = "", what[64];
        const char *text = keys, *laws = i == 2 ? "laws" : "contact";
        for (bool of_laws = false; next_line(&text, line);) {
            if (strcmp(line, "## Parameters of laws") == 0) of_laws = true;
            if (strncmp(line, "### ", 4) == 0 && !quoted(line + 4, section)) section[0] = '\0';
            if (strncmp(line, "| `", 3) != 0 || !quoted(line + 2, key) || !strcmp(key, "kind")) continue;
            const char *chosen = strstr(line, "(for `what: ");
            if (!chosen || sscanf(chosen, "(for `what: %63[^,`]", what) != 1) what[0] = '\0';
            if (!strcmp(key, "what")) what[0] = '\0';
            tr_status st;
            ask_reader(kinds[i], of_laws ? laws : section, key, what, &st);
            bool refused = strstr(st.text, "unknown key") || strstr(st.text, "is not for");
            bool derived = strstr(st.text, "cannot be given");
            if (refused || derived != !!strstr(line, "cannot be given"))
                fail_msg("%s, %s: %s\n%s", kinds[i], section, line, st.text);
            n++;
        }
        free(keys);
    }
    assert_true(n > 150); /* four kinds with some 40 keys each */
}

/* Markdown: as many cells in a row as in the head; a | inside of a cell is written \|. */
static void every_row_has_five_cells(void **state) {
    (void)state;
    char *all = keys_of(NULL), line[LINE];
    const char *text = all;
    while (next_line(&text, line)) {
        int bars = 0;
        for (const char *c = line; *c; c++) bars += *c == '|' && (c == line || c[-1] != '\\');
        if (*line == '|' && bars != 6) fail_msg("%d bars: %s", bars, line);
    }
    free(all);
}

static void a_wrong_kind_is_refused_with_the_right_ones(void **state) {
    (void)state;
    tr_status st = {0};
    assert_null(tr_scene_keys("bodie", tr_laws_catalog(), &st));
    assert_int_equal(st.code, TR_BAD_CASE);
    assert_non_null(strstr(st.text, "did you mean `bodies`"));
    for (int i = 0; i < 4; i++) assert_non_null(strstr(st.text, kinds[i]));
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_key_of_every_shipped_case_is_in_the_table),
        cmocka_unit_test(every_parameter_of_every_law_is_in_the_table),
        cmocka_unit_test(the_reader_takes_every_key_of_the_tables),
        cmocka_unit_test(every_row_has_five_cells),
        cmocka_unit_test(a_wrong_kind_is_refused_with_the_right_ones),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
