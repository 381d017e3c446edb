/* SPDX-License-Identifier: MIT */
#include "out/plot.h"

#include "base/temporary.h"
#include "base/program.h"
#include "out/dir.h"
#include "out/manifest.h"
#include <errno.h>
#include <fcntl.h>
#include <spawn.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

extern char **environ;

static const char biaxial_script[] =
    "# SPDX-License-Identifier: MIT\n"
    "# Curves of the biaxial test. Run in this directory: gnuplot plot.gp\n"
    "if (!exists('part')) { part = '' }\n"
    "set datafile separator ','\n"
    "array out[2] = ['biaxial.svg'.part, 'biaxial.png'.part]\n"
    "do for [k = 1:2] {\n"
    "    if (k == 1) { set terminal svg size 900,720 font 'DejaVu Sans,17' enhanced background '#ffffff' }\n"
    "    if (k == 2) { set terminal pngcairo size 1350,1080 font 'DejaVu Sans,20' enhanced linewidth 1.5 }\n"
    "    set output out[k]\n"
    "    set multiplot layout 2,1 title caption font ',15' margins 0.12,0.96,0.11,0.91 spacing 0.06\n"
    "    set grid linecolor '#d0d0d0'\n"
    "    set xrange [0:100*strain_end]\n"
    "    set key bottom right box linecolor '#d0d0d0' opaque width 1 height 0.3\n"
    "    set yrange [*<0:*]\n"
    "    set format x ''\n"
    "    set ylabel 'sin φ = (σ_1 − σ_2)/(σ_1 + σ_2)' offset 1\n"
    "    plot 'history.csv' using (100*$1):'sin_phi' every ::1 with lines linewidth 2.5 linecolor '#7f4a90' title "
    "'stress ratio sin φ'\n"
    "    set yrange [*:*]\n"
    "    set format x '%g'\n"
    "    set xlabel 'axial strain ε_1 (%), compression positive'\n"
    "    set ylabel 'void ratio e' offset 1\n"
    "    plot 'history.csv' using (100*$1):'void_ratio' every ::1 with lines linewidth 2.5 linecolor '#00714f' title "
    "'void ratio e'\n"
    "    unset multiplot\n"
    "    unset output\n"
    "    unset xlabel\n"
    "}\n";

static const char contact_script[] =
    "# SPDX-License-Identifier: MIT\n"
    "# All laws along the path of one contact. Run in this directory: gnuplot plot.gp\n"
    "if (!exists('part')) { part = '' }\n"
    "set datafile separator ','\n"
    "array out[2] = ['contact.svg'.part, 'contact.png'.part]\n"
    "array colors[7] = ['#7f4a90', '#00714f', '#7fbf9f', '#d08aa8', '#a89a00', '#c9a0d0', '#000000']\n"
    "height = 330*(2 + rolling)\n"
    "do for [k = 1:2] {\n"
    "    if (k == 1) { set terminal svg size 900,height font 'DejaVu Sans,17' enhanced background '#ffffff' }\n"
    "    if (k == 2) { set terminal pngcairo size 1350,3*height/2 font 'DejaVu Sans,20' enhanced linewidth 1.5 }\n"
    "    set output out[k]\n"
    "    set multiplot layout 2 + rolling,1 margins 0.17,0.96,(rolling ? 0.09 : 0.12),0.97 spacing (rolling ? 0.09 : "
    "0.14)\n"
    "    set grid linecolor '#d0d0d0'\n"
    "    set key bottom right box linecolor '#d0d0d0' opaque width 1 height 0.3 noenhanced\n"
    "    set xlabel 'sliding u_{slide} (µm)'\n"
    "    set ylabel 'friction Q ('.force.')'\n"
    "    plot for [i = 1:laws] 'contact.csv' skip 1 every laws::i - 1 using (1e6*$4):7 with lines linewidth 2.5 \\\n"
    "        linecolor rgb colors[1 + (i - 1)%7] dashtype 1 + (i - 1)/7 title label[i]\n"
    "    unset key\n"
    "    set xlabel 'step of the path'\n"
    "    set ylabel 'Q/(μP), its bound is ±1'\n"
    "    set yrange [-1.05:1.05]\n"
    "    plot for [i = 1:laws] 'contact.csv' skip 1 every laws::i - 1 using 2:8 with lines \\\n"
    "        linewidth 2.5 linecolor rgb colors[1 + (i - 1)%7] dashtype 1 + (i - 1)/7\n"
    "    set yrange [*:*]\n"
    "    set xlabel 'rolling u_{roll} (µm)'\n"
    "    set ylabel 'moment on body 1 ('.moment.')'\n"
    "    if (rolling) {\n"
    "        plot for [i = 1:laws] 'contact.csv' skip 1 every laws::i - 1 using (1e6*$5):10 with lines linewidth 2.5 "
    "\\\n"
    "            linecolor rgb colors[1 + (i - 1)%7] dashtype 1 + (i - 1)/7\n"
    "    }\n"
    "    unset multiplot\n"
    "    unset output\n"
    "}\n";

bool tr_plot_available(void) {
    return tr_program_available("gnuplot");
}

/* gnuplot, working in dir, silent. -d: without the user's settings. It has its own process group, so that Ctrl-C leaves
 * no half picture. code: its exit code; -1: a signal. False: it did not start. */
static bool run_gnuplot(const char *dir, const char *script, int *code, tr_status *st) {
    char *const argv[] = {"gnuplot", "-d", "-e", "part = '.part'", (char *)script, NULL};
    posix_spawn_file_actions_t actions;
    posix_spawnattr_t attr;
    pid_t child;
    int status = -1;
    posix_spawnattr_init(&attr);
    posix_spawnattr_setflags(&attr, POSIX_SPAWN_SETPGROUP);
    posix_spawn_file_actions_init(&actions);
    int error = posix_spawn_file_actions_addchdir_np(&actions, dir); /* otherwise gnuplot would write elsewhere */
    if (!error) error = posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    if (!error) error = posix_spawnp(&child, argv[0], &actions, &attr, argv, environ);
    posix_spawn_file_actions_destroy(&actions);
    posix_spawnattr_destroy(&attr);
    if (error) return tr_status_fail(st, TR_FILE, "error: cannot start gnuplot: %s", strerror(error));
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) continue;
    *code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    return true;
}

/* gnuplot does not notice a full disk: a picture is whole if it ends as its format does. */
static bool is_whole(const char *path, const char *end, size_t size) {
    char tail[16];
    FILE *file = fopen(path, "rb");
    bool whole = file && fseek(file, -(long)size, SEEK_END) == 0 && fread(tail, 1, size, file) == size &&
                 memcmp(tail, end, size) == 0;
    if (file) fclose(file);
    return whole;
}

/* The picture gets its name; with gnuplot's code != 0 it is removed. */
static bool keep(const char *part, const char *path, const char *end, size_t size, int code, tr_status *st) {
    if (!code && is_whole(part, end, size)) return tr_temporary_rename(part, path, st);
    unlink(part);
    return code || tr_status_fail(st, TR_FILE, "error: cannot write %s: gnuplot did not finish it", path);
}

/* The names are made first: if memory is short, gnuplot does not start, and no parts are left. */
bool tr_plot_draw(const char *dir, const char *script, const char *stem, int *code, tr_status *st) {
    static const char svg_end[] = "</svg>\n\n", png_end[] = "IEND\xae\x42\x60\x82";
    char name[2][32], path[2][TR_PATH], *part[2] = {NULL};
    bool ok = true;
    for (int k = 0; k < 2 && ok; k++) {
        snprintf(name[k], sizeof name[k], "%s%s", stem, k ? ".png" : ".svg");
        ok = tr_manifest_add(dir, name[k], st) && tr_dir_path(path[k], dir, name[k], st) &&
             (part[k] = tr_temporary_name(path[k], st));
    }
    if (ok && (ok = run_gnuplot(dir, script, code, st))) {
        bool svg = keep(part[0], path[0], svg_end, sizeof svg_end - 1, *code, st);
        ok = keep(part[1], path[1], png_end, sizeof png_end - 1, *code, st) && svg;
    }
    free(part[0]), free(part[1]);
    return ok;
}

bool tr_plot_biaxial(const char *dir, const char *caption, double strain_end, int *code, tr_status *st) {
    tr_file file;
    if (!tr_file_open(&file, dir, "plot.gp", st)) return false;
    fprintf(file.stream, "caption = '%s'\nstrain_end = %g\n%s", caption, strain_end, biaxial_script);
    return tr_file_commit(&file, st) && tr_plot_draw(dir, "plot.gp", "biaxial", code, st);
}

bool tr_plot_contact(const char *dir, const char *const *label, int n_laws, bool rolling, tr_shape shape, int *code,
                     tr_status *st) {
    tr_file file;
    if (!tr_file_open(&file, dir, "plot.gp", st)) return false;
    bool sphere = shape == TR_SHAPE_SPHERE;
    fprintf(file.stream, "laws = %d\nrolling = %d\nforce = '%s'\nmoment = '%s'\narray label[laws]\n", n_laws, rolling,
            sphere ? "N" : "N/m", sphere ? "N m" : "N");
    for (int i = 0; i < n_laws; i++) fprintf(file.stream, "label[%d] = '%s'\n", i + 1, label[i]);
    fputs(contact_script, file.stream);
    return tr_file_commit(&file, st) && tr_plot_draw(dir, "plot.gp", "contact", code, st);
}
