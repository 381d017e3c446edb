/* SPDX-License-Identifier: MIT */
#include "out/plot_converge.h"

#include "out/dir.h"
#include "out/plot.h"
#include <math.h>

static const char head[] = "# SPDX-License-Identifier: MIT\n"
                           "# Run in this directory: gnuplot NAME.gp\n"
                           "if (!exists('part')) { part = '' }\n"
                           "set datafile separator ','\n"
                           "set datafile missing NaN\n"
                           "array colors[7] = ['#0072b2', '#d55e00', '#009e73', '#cc79a7', '#e69f00', '#56b4e9', "
                           "'#000000']\n"
                           "color(i) = colors[1 + (i - 1)%7]\n";

static const char terminals[] =
    "    if (k == 1) { set terminal svg size 900,height font 'DejaVu Sans,17' enhanced background '#ffffff' }\n"
    "    if (k == 2) { set terminal pngcairo size 1350,3*height/2 font 'DejaVu Sans,20' enhanced linewidth 1.5 }\n"
    "    set output out[k]\n";

/* Columns of levels.csv: number, cause, setting, seeds, value, standard_error, error, seconds, own, front. */
static const char time_body[] =
    "    set multiplot layout panels,1 margins 0.16,0.96,0.5/(1 + 2*panels),0.95 spacing 0.35/(1 + panels)\n"
    "    set grid linecolor '#d0d0d0'\n"
    "    set logscale xy\n"
    "    set format x '10^{%L}'\n"
    "    set format y '10^{%L}'\n"
    "    set xrange [fast:slow]\n"
    "    set xlabel 'time of a run (s)'\n"
    "    set ylabel 'error'\n"
    "    set key top right box linecolor '#d0d0d0' opaque width 1 height 0.3 noenhanced\n"
    "    of(q, c) = strcol(1) eq number[q] && strcol(2) eq cause[c] && valid(7) && column(7) > 0\n"
    "    do for [q = 1:panels] {\n"
    "        set title number[q] noenhanced\n"
    "        set yrange [low[q]:high[q]]\n"
    "        plot for [c = 1:causes] 'levels.csv' skip 1 using (of(q, c) && column(10) == 1 ? column(8) : NaN):7 \\\n"
    "            with lines linewidth 2 linecolor rgb color(c) notitle, \\\n"
    "            for [c = 1:causes] 'levels.csv' skip 1 using (of(q, c) ? column(8) : NaN):7 \\\n"
    "            with points pointtype 7 linecolor rgb color(c) title cause[c], \\\n"
    "            'levels.csv' skip 1 using (strcol(1) eq number[q] && column(9) == 1 && column(7) > 0 ? column(8) : "
    "NaN):7 \\\n"
    "            with points pointtype 6 pointsize 2.2 linecolor rgb '#000000' title 'as the case is'\n"
    "    }\n"
    "    unset multiplot\n"
    "    unset output\n"
    "}\n";

static const char parts_body[] =
    "    set style data histograms\n"
    "    set style histogram rowstacked\n"
    "    set style fill solid border rgb '#ffffff'\n"
    "    set boxwidth 0.6\n"
    "    set yrange [0:112]\n"
    "    set ytics 0,20,100\n"
    "    set grid ytics linecolor '#d0d0d0'\n"
    "    set ylabel 'part of the error (%)'\n"
    "    set key outside top center horizontal noenhanced\n"
    "    set xtics noenhanced rotate by 9 right font ',13'\n"
    "    plot for [c = 1:causes] $parts using c + 2:xticlabels(1) linecolor rgb color(c) title cause[c], \\\n"
    "        $parts using 0:(106):2 with labels notitle\n"
    "    unset output\n"
    "}\n";

static void put_names(FILE *f, const tr_plot_converge_labels *l) {
    fprintf(f, "causes = %d\narray cause[%d]\n", l->n_causes, l->n_causes);
    for (int i = 0; i < l->n_causes; i++) fprintf(f, "cause[%d] = '%s'\n", i + 1, l->cause[i]);
}

static bool write_time(const char *dir, const tr_plot_converge_labels *l, tr_status *st) {
    tr_file file;
    if (!tr_file_open(&file, dir, "converge-time.gp", st)) return false;
    FILE *f = file.stream;
    int n = l->n_numbers;
    fputs(head, f);
    put_names(f, l);
    fprintf(f, "panels = %d\nheight = %d\nfast = %g\nslow = %g\n", n, 150 + 350 * n, l->fast / 1.5, l->slow * 1.5);
    fprintf(f, "array number[%d]\narray low[%d]\narray high[%d]\n", n, n, n);
    for (int q = 0; q < n; q++) {
        bool any = l->number[q].low > 0;
        fprintf(f, "number[%d] = '%s'; low[%d] = %g; high[%d] = %g\n", q + 1, l->number[q].name, q + 1,
                any ? l->number[q].low / 2 : 1e-12, q + 1, any ? l->number[q].high * 2 : 1);
    }
    fprintf(f, "array out[2] = ['converge-time.svg'.part, 'converge-time.png'.part]\ndo for [k = 1:2] {\n%s%s",
            terminals, time_body);
    return tr_file_commit(&file, st);
}

static bool write_parts(const char *dir, const tr_plot_converge_labels *l, tr_status *st) {
    tr_file file;
    if (!tr_file_open(&file, dir, "converge-parts.gp", st)) return false;
    FILE *f = file.stream;
    fputs(head, f);
    put_names(f, l);
    fputs("height = 560\n$parts << EOD\n", f);
    for (int q = 0; q < l->n_numbers; q++) {
        double sum = 0; /* of the parts; the error in all is less where noise adds up as squares */
        for (int i = 0; i < l->n_causes; i++) sum += isfinite(l->number[q].part[i]) ? l->number[q].part[i] : 0;
        fprintf(f, "%s,%s± %.2g", l->number[q].name, l->number[q].whole ? "" : "known: ", l->number[q].total);
        for (int i = 0; i < l->n_causes; i++) {
            double part = 100 * l->number[q].part[i] / sum;
            fprintf(f, ",%.4g", isfinite(part) ? part : 0);
        }
        putc('\n', f);
    }
    fprintf(f, "EOD\narray out[2] = ['converge-parts.svg'.part, 'converge-parts.png'.part]\ndo for [k = 1:2] {\n%s%s",
            terminals, parts_body);
    return tr_file_commit(&file, st);
}

bool tr_plot_converge(const char *dir, const tr_plot_converge_labels *labels, int *code, tr_status *st) {
    int parts = 0;
    if (!write_time(dir, labels, st) || !write_parts(dir, labels, st) ||
        !tr_plot_draw(dir, "converge-time.gp", "converge-time", code, st) ||
        !tr_plot_draw(dir, "converge-parts.gp", "converge-parts", &parts, st))
        return false;
    if (!*code) *code = parts;
    return true;
}
