/* SPDX-License-Identifier: MIT */
/* trundle bench --sizes: time of a step from 100 disks to a million. */
#include "cli/bench_sizes.h"

#include "cli/bench_case.h"
#include "cli/open.h"
#include "out/table.h"
#include "study/bench.h"
#include "study/bench_sizes.h"
#include <stdio.h>

static const int SIZES[] = {100, 200, 400, 1000, 4000, 10000, 40000, 100000, 1000000};
enum { N = sizeof SIZES / sizeof *SIZES, FIT_FROM = 1000 };

static void write_row(const tr_bench_size *r, FILE *csv) {
    char quartiles[32];
    snprintf(quartiles, sizeof quartiles, "%.1f to %.1f", r->ns.low, r->ns.high);
    printf("%8d %11.2f %7.1f %16s %10.0f %8.0f %8.1f %8.2f %6.0f\n", r->disks, r->us.median, r->ns.median, quartiles,
           r->touching, r->steps, r->refreshes, r->rebuild, r->bytes_per_disk);
    const double number[] = {r->us.median, r->us.low, r->us.high, r->ns.median, r->ns.low,  r->ns.high,
                             r->touching,  r->listed, r->steps,   r->refreshes, r->rebuild, r->bytes_per_disk};
    if (!csv) return;
    fprintf(csv, "%d", r->disks);
    for (size_t i = 0; i < sizeof number / sizeof *number; i++) putc(',', csv), tr_cell_put(csv, number[i], 8);
    putc('\n', csv);
}

static void write_all(const tr_bench_size *r, int n, FILE *csv) {
    double disks[N], us[N];
    int fitted = 0;
    printf(
        "a cycle of each in turn, from one search of all pairs to the next; medians of %d (above 100000 disks: one)\n",
        TR_BENCH_CYCLES);
    printf("%8s %11s %7s %16s %10s %8s %8s %8s %6s\n", "disks", "us per", "ns per", "quartiles", "touching", "steps",
           "lists", "rebuild", "bytes");
    printf("%8s %11s %7s %16s %10s %8s %8s %8s %6s\n", "", "step", "contact", "", "contacts", "a cycle", "a cycle",
           "share", "a disk");
    if (csv)
        fputs(
            "disks,us_per_step,us_lower_quartile,us_upper_quartile,ns_per_contact,ns_lower_quartile,ns_upper_quartile,"
            "touching_contacts,listed_contacts,steps_per_cycle,lists_per_cycle,rebuild_share,bytes_per_disk\n",
            csv);
    for (int i = 0; i < n; i++) {
        write_row(&r[i], csv);
        if (r[i].disks >= FIT_FROM) disks[fitted] = r[i].disks, us[fitted++] = r[i].us.median;
    }
    if (fitted > 1)
        printf("time of a step ~ N^%.2f for N = %d to %.0f\n", tr_bench_slope(disks, us, fitted), FIT_FROM,
               disks[fitted - 1]);
}

bool tr_cli_bench_sizes(const tr_bench_arguments *a, tr_status *st) {
    tr_scene scene = {0};
    tr_bench_size sizes[N] = {0};
    tr_file csv = {0};
    int n = 0;
    while (n < N && SIZES[n] <= a->largest) sizes[n].disks = SIZES[n], n++;
    bool ok = tr_cli_bench_case(a, NULL, 0, &scene, st) && (!a->out || tr_cli_open(&csv, a->out, a->file, st));
    if (ok) scene.output.energy = false;
    ok = ok && tr_bench_sizes(&scene, a->threads, sizes, n, st);
    if (ok) write_all(sizes, n, csv.stream);
    ok = ok && (!a->out || tr_file_commit(&csv, st));
    tr_file_discard(&csv), tr_scene_free(&scene);
    return ok;
}
