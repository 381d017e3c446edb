/* SPDX-License-Identifier: MIT */
/* The keys of a case, in the order in which the resolved case lists them. Bounds are wide: they catch slips of units
 * and of signs, not unusual physics. No key may be the name of a unit, so that `m` is always the metre. */
#include "scene/tables.h"

#include "scene/language.h"
#include "scene/what.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#define AT(field) offsetof(STRUCT, field)

#define STRUCT tr_scene
#define SHAPE                                                                                                          \
    {                                                                                                                  \
        "shape", TR_CHOICE, TR_DIM_NUMBER, "", "disk", 0, 0, "disk|sphere", AT(shape),                                 \
            "disk: a cylinder per metre of length; sphere: moves in the plane"                                         \
    }
static const tr_param root_worlds[] = {SHAPE};
static const tr_param bodies_shape[] = {SHAPE};
static const tr_param root[] = {
    {"kind", TR_CHOICE, TR_DIM_NUMBER, "", NULL, 0, 0, "biaxial|bodies|contact|patch", AT(kind),
     "what is simulated: a biaxial test, a few bodies, one contact along a path, or the inside of one"},
};
static const tr_param root_biaxial[] = {
    {"seed", TR_SEED, TR_DIM_NUMBER, "", "1", 0, 0, NULL, AT(seed),
     "start of the random numbers: same seed, same sample"},
    {"boundary", TR_CHOICE, TR_DIM_NUMBER, "", "walls", 0, 0, "walls|periodic", AT(boundary),
     "four walls around the sample, or a periodic cell"},
};
static const tr_param root_bodies[] = {
    {"time_end", TR_REAL, TR_DIM_TIME, "s", NULL, 1e-12, 1e6, NULL, AT(time_end), "time that the run covers"},
    {"label", TR_TEXT, TR_DIM_NUMBER, "", "", 0, sizeof((tr_scene *)0)->label, NULL, AT(label),
     "name of this document, among several in one file"},
};
static const tr_param root_language[] = {
    {"language", TR_CHOICE, TR_DIM_NUMBER, "", "en", 0, 0, tr_language_choices, AT(language),
     "of the words in pictures: English or German; a lesson or label may be in both, {en: ..., de: ...}"},
};
static const tr_param root_pair[] = {
    {"E_star", TR_REAL, TR_DIM_MODULUS, "Pa", "bodies.E/(2*(1 - bodies.nu^2))", 1e-4, 1e18, NULL, AT(pair.E_star),
     "contact modulus, 1/E_star = sum of (1 - nu^2)/E of both bodies"},
    {"R_star", TR_REAL, TR_DIM_LENGTH, "m", "bodies.R1*bodies.R2/(bodies.R1 + bodies.R2)", 1e-10, 1e3, NULL,
     AT(pair.R_star), "1/R_star = 1/R1 + 1/R2"},
};
static const tr_param root_contact[] = {
    {"nu", TR_REAL, TR_DIM_NUMBER, "1", "bodies.nu", -0.999, 0.5, NULL, AT(pair.nu), "Poisson's ratio of both bodies"},
    {"depth", TR_REAL, TR_DIM_LENGTH, "m", "bodies.depth", 1e-12, 1e6, NULL, AT(pair.d),
     "d of the line contact, whose approach is (2P/(pi E_star)) (ln(2d/a) + 1/2)"},
};
#define DEPTH(default_)                                                                                                \
    {"depth",                                                                                                          \
     TR_REAL,                                                                                                          \
     TR_DIM_LENGTH,                                                                                                    \
     "m",                                                                                                              \
     default_,                                                                                                         \
     1e-12,                                                                                                            \
     1e6,                                                                                                              \
     "Lambda",                                                                                                         \
     AT(pair.depth),                                                                                                   \
     "d of the line contact; by default that of two disks pressed between plates [Johnson1985]"},                      \
    {                                                                                                                  \
        "Lambda", TR_REAL, TR_DIM_NUMBER, "1", NULL, 0.7, 100, "depth", AT(pair.Lambda),                               \
            "ln(2d/a) at the force of the first segment: another way to give the depth"                                \
    }
static const tr_param root_patch[] = {
    {"mu", TR_REAL, TR_DIM_NUMBER, "1", NULL, 1e-9, 100, NULL, AT(patch.mu), "friction coefficient"},
    {"solver", TR_CHOICE, TR_DIM_NUMBER, "", "half-plane", 0, 0, "half-plane|brush|carter|cattaneo", AT(patch.solver),
     "half-plane: exact, transient; brush: Winkler bed; carter: steady rolling; cattaneo: sliding from rest"},
    {"elements", TR_COUNT, TR_DIM_NUMBER, "", "200", 3, 4000, NULL, AT(patch.elements), "elements across the contact"},
    DEPTH("2*sqrt(bodies.R1*bodies.R2)/exp(1)"),
};
static const tr_param bodies_depth[] = {DEPTH("2*sqrt(R1*R2)/exp(1)")};
const char tr_tables_depth_from_Lambda[] = "path.0.a*exp(bodies.Lambda)/2";
#undef STRUCT

#define STRUCT tr_scene_lesson
#define LINE(key, doc)                                                                                                 \
    { #key, TR_TEXT, TR_DIM_NUMBER, "", "", 0, sizeof((STRUCT *)0)->key, NULL, AT(key), doc }
static const tr_param lesson[] = {
    LINE(title, "title of the film"),
    LINE(equation, "the equation that the film shows, with its source"),
    LINE(sentence, "what to look at, in a sentence"),
    LINE(question, "question to the class"),
    LINE(choices, "two to four answers to choose from, with | between them"),
    {"right", TR_COUNT, TR_DIM_NUMBER, "", "0", 0, 4, NULL, AT(right), "number of the right choice, from 1"},
    LINE(answer, "answer to the question"),
    LINE(happens, "what happens in the film, for a person who cannot see it; by default the sentence"),
};
#undef STRUCT

#define STRUCT tr_scene_sample
static const tr_param sample[] = {
    {"disks", TR_COUNT, TR_DIM_NUMBER, "", "400", 2, 1e7, NULL, AT(disks),
     "number of disks; with file: the number of its rows"},
    {"r_min", TR_REAL, TR_DIM_LENGTH, "m", NULL, 1e-9, 1e3, "file", AT(r_min),
     "smallest radius; radii are uniform from r_min to r_max"},
    {"r_max", TR_REAL, TR_DIM_LENGTH, "m", NULL, 1e-9, 1e3, "file", AT(r_max), "largest radius"},
    {"density", TR_REAL, TR_DIM_DENSITY, "kg/m^3", "2700", 1e-3, 1e6, NULL, AT(density), "density of the disks"},
    {"file", TR_TEXT, TR_DIM_NUMBER, "", "", 0, sizeof((STRUCT *)0)->file, NULL, AT(file),
     "a packing to begin with, in place of r_min and r_max: CSV with columns x, y, r [m], or a dump of LAMMPS"},
    {"file_hash", TR_SEED, TR_DIM_NUMBER, "", "0", 0, 0, NULL, AT(file_hash),
     "what the file held when it was read; 0: not known. Another file is refused"},
    {"width", TR_REAL, TR_DIM_LENGTH, "m", "0", 0, 1e6, NULL, AT(width),
     "of the box of the file, from x = 0; 0: that of the dump, or around the disks"},
    {"height", TR_REAL, TR_DIM_LENGTH, "m", "0", 0, 1e6, NULL, AT(height), "the same from y = 0"},
};
#undef STRUCT

#define STRUCT tr_scene_contact
static const tr_param contact[] = {
    {"normal", TR_CHOICE, TR_DIM_NUMBER, "", "linear", 0, 0, NULL, AT(normal.law), "law of the normal force"},
    {"friction", TR_CHOICE, TR_DIM_NUMBER, "", "coulomb-spring", 0, 0, NULL, AT(friction.law),
     "law of the friction force"},
    {"rolling", TR_CHOICE, TR_DIM_NUMBER, "", "wang-spring", 0, 0, NULL, AT(rolling.law),
     "law of the rolling resistance"},
    {"rolling_velocity", TR_CHOICE, TR_DIM_NUMBER, "", "wang", 0, 0, NULL, AT(rolling_velocity),
     "definition of the rolling velocity"},
    {"arms", TR_CHOICE, TR_DIM_NUMBER, "", "shared", 0, 0, NULL, AT(arms),
     "from the centres to the contact point, for sliding and torque: shared R_i |X21|/(R1+R2), or midpoint R_i - "
     "overlap/2; at a wall R, or R - overlap"},
};
#undef STRUCT

#define STRUCT tr_scene_compaction
static const tr_param compaction[] = {
    {"pressure", TR_REAL, TR_DIM_STRESS, "Pa|N/m", NULL, 1e-3, 1e12, NULL, AT(pressure), "pressure on all four walls"},
    {"mu", TR_REAL, TR_DIM_NUMBER, "1", "0", 0, 10, NULL, AT(mu),
     "friction coefficient during compaction; 0 gives the densest sample"},
    {"inertial_number", TR_REAL, TR_DIM_NUMBER, "1", "1e-2", 1e-9, 1, NULL, AT(inertial_number),
     "largest speed of the walls or sides, as an inertial number"},
    {"unbalanced", TR_REAL, TR_DIM_NUMBER, "1", "1e-4", 1e-12, 0.1, NULL, AT(unbalanced),
     "compaction ends when mean net force / mean contact force is below this"},
};
#undef STRUCT

#define STRUCT tr_scene_shear
static const tr_param shear[] = {
    {"lateral_pressure", TR_REAL, TR_DIM_STRESS, "Pa|N/m", "compaction.pressure", 1e-3, 1e12, NULL,
     AT(lateral_pressure), "pressure on the two lateral walls, or the held stress of a periodic cell"},
    {"hold", TR_CHOICE, TR_DIM_NUMBER, "", "lateral", 0, 0, "lateral|mean", AT(hold),
     "held stress of a periodic cell: lateral, or mean (s1 + s2)/2"},
    {"inertial_number", TR_REAL, TR_DIM_NUMBER, "1", "1e-3", 1e-9, 1, NULL, AT(inertial_number),
     "I = strain rate sqrt(mean disk mass / lateral_pressure); below 1e-3 quasi-static"},
    {"strain_end", TR_REAL, TR_DIM_NUMBER, "1", "0.20", 1e-9, 0.5, NULL, AT(strain_end),
     "axial strain at the end, compression positive"},
    {"walls", TR_CHOICE, TR_DIM_NUMBER, "", "smooth", 0, 0, "smooth|rough", AT(walls),
     "smooth: normal force only; rough: the laws of the disks"},
};
#undef STRUCT

#define STRUCT struct tr_scene_gravity
static const tr_param gravity[] = {
    {"x", TR_REAL, TR_DIM_ACCELERATION, "m/s^2", "0", -1e9, 1e9, NULL, AT(x), "acceleration of gravity to the right"},
    {"y", TR_REAL, TR_DIM_ACCELERATION, "m/s^2", "0", -1e9, 1e9, NULL, AT(y), "acceleration of gravity upward"},
    {"turn", TR_REAL, TR_DIM_SPIN, "rad/s", "0", -1e6, 1e6, NULL, AT(turn),
     "rate at which gravity turns, counter-clockwise: the slope steepens"},
};
#undef STRUCT

#define STRUCT tr_scene_step
#define SAFETY(default_, more)                                                                                         \
    { "safety", TR_REAL, TR_DIM_NUMBER, "1", default_, 1e-6, 1, NULL, AT(safety),                                      \
      "time step over its stability bound" more }
/* From `trundle verify precision`: a few bodies need accurate numbers, and at 0.1 most are good to 1e-3. The scatter of
 * an assembly is far larger than the error of its step. */
static const tr_param step_bodies[] = {
    SAFETY("0.1", "; at 0.1 an oblique rebound errs by 6 %, a normal one by 1 %, a smooth motion by 0.1 %")};
static const tr_param step_biaxial[] = {SAFETY("0.4", "")};
static const tr_param step[] = {
    {"dt", TR_REAL, TR_DIM_TIME, "s", "0", 0, 1e6, NULL, AT(dt), "time step; 0: safety times the bound"},
    {"allow_unstable", TR_SWITCH, TR_DIM_NUMBER, "", "no", 0, 0, NULL, AT(allow_unstable), "allow dt above the bound"},
};
#undef STRUCT

#define STRUCT tr_scene_output
static const tr_param output[] = {
    {"frames", TR_COUNT, TR_DIM_NUMBER, "", "20", 0, 1e5, NULL, AT(frames), "number of pictures; 0: none"},
    {"rows", TR_COUNT, TR_DIM_NUMBER, "", "400", 3, 1e6, NULL, AT(rows), "rows of history.csv"},
    {"contacts", TR_COUNT, TR_DIM_NUMBER, "", "1", 0, 1e5, NULL, AT(contacts), "number of instants in contacts.csv"},
    {"paths", TR_CONTACT_IDS, TR_DIM_NUMBER, "", "[]", 0, TR_MAX_CONTACT_IDS, NULL, AT(paths),
     "contacts whose path is written: 17-42 (two disks), wall0-3 (wall 0, disk 3), most-mobilised (at the end)"},
};
static const tr_param output_bodies[] = {
    {"curve", TR_CHOICE, TR_DIM_NUMBER, "", "none", 0, 0, "none|speed|velocities|creepage|spin", AT(curve),
     "drawn over time: speed of disk 0; V_s and V_r, or creepage, of `contact`, else the first; spin of the last disk"},
    {"contact", TR_CONTACT_IDS, TR_DIM_NUMBER, "", "[]", 0, 1, NULL, AT(contact),
     "shown in the panel, alone: 0-1 (two disks), wall0-2 (wall 0, disk 2); by default the first four"},
    {"still", TR_REAL, TR_DIM_TIME, "s", "time_end", 0, 1e6, NULL, AT(still), "time of still.png"},
    {"view", TR_CHOICE, TR_DIM_NUMBER, "", "class", 0, 0, "class|expert", AT(view),
     "pictures for a class: three numbers at most, large type; for an expert: all definitions, all numbers"},
};
static const tr_param output_biaxial[] = {
    {"color", TR_CHOICE, TR_DIM_NUMBER, "", "motion", 0, 0, "mobilisation|sliding|rolling|slip|spin|motion", AT(color),
     "what colours the contacts: rolling beside sliding (motion), |f_t|/(mu f_n), sliding or rolling velocity, the "
     "share of the width that slips; or the disks: how far each has spun so far"},
    {"energy", TR_SWITCH, TR_DIM_NUMBER, "", "yes", 0, 0, NULL, AT(energy), "keep the energy ledger"},
    {"path_rows", TR_COUNT, TR_DIM_NUMBER, "", "0", 0, 1e6, NULL, AT(path_rows),
     "number of instants in paths.csv, the path of all contacts, for trundle replay; 0: no file"},
    {"increments", TR_SWITCH, TR_DIM_NUMBER, "", "no", 0, 0, NULL, AT(increments),
     "adds the motion of contacts since the row before: to history.csv rolling and creep over sliding, runs, a and the "
     "part of friction, to contacts.csv the sliding, rolling and creep of each contact"},
};
static const tr_param output_curves[] = {
    {"curves", TR_SWITCH, TR_DIM_NUMBER, "", "yes", 0, 0, NULL, AT(curves), "draw the curves with gnuplot"},
};
#undef STRUCT

#define STRUCT tr_scene_patch
static const tr_param output_patch[] = {
    {"frames", TR_COUNT, TR_DIM_NUMBER, "", "20", 0, 1e5, NULL, AT(frames), "number of pictures; 0: none"},
    {"snapshots", TR_COUNT, TR_DIM_NUMBER, "", "20", 0, 1e5, NULL, AT(snapshots), "number of instants in patch.csv"},
};
#undef STRUCT

#define STRUCT tr_scene_disk
static const tr_param disk[] = {
    {"radius", TR_REAL, TR_DIM_LENGTH, "m", NULL, 1e-9, 1e3, NULL, AT(radius), "radius"},
    {"density", TR_REAL, TR_DIM_DENSITY, "kg/m^3", "2700", 1e-3, 1e6, NULL, AT(density),
     "density; no effect with motion: prescribed or orbit"},
    {"inertia", TR_REAL, TR_DIM_NUMBER, "1", "0", 0, 1e6, NULL, AT(inertia),
     "moment of inertia over m radius^2: 1/2 of a disk, 2/5 of a sphere, 1 of a hoop; 0: of its shape, whole or a "
     "ring"},
    {"ring", TR_REAL, TR_DIM_LENGTH, "m", "0", 0, 1e3, NULL, AT(ring),
     "thickness of a ring (spheres: a shell), of which radius is the inside and touches what is inside; 0: no ring"},
    {"x", TR_REAL, TR_DIM_LENGTH, "m", NULL, -1e6, 1e6, NULL, AT(x), "centre at the start"},
    {"y", TR_REAL, TR_DIM_LENGTH, "m", NULL, -1e6, 1e6, NULL, AT(y), "centre at the start"},
    {"angle", TR_REAL, TR_DIM_NUMBER, "rad", "0", -1e9, 1e9, NULL, AT(angle),
     "rotation at the start, counter-clockwise"},
    {"vx", TR_REAL, TR_DIM_SPEED, "m/s", "0", -1e6, 1e6, NULL, AT(vx), "velocity at the start"},
    {"vy", TR_REAL, TR_DIM_SPEED, "m/s", "0", -1e6, 1e6, NULL, AT(vy), "velocity at the start"},
    {"spin", TR_REAL, TR_DIM_SPIN, "rad/s", "0", -1e9, 1e9, NULL, AT(spin),
     "rotation rate at the start, counter-clockwise"},
    {"torque", TR_REAL, TR_DIM_MOMENT, "N|N*m", "0", -1e15, 1e15, NULL, AT(torque),
     "applied torque, counter-clockwise"},
    {"motion", TR_CHOICE, TR_DIM_NUMBER, "", "free", 0, 0, "free|prescribed|orbit|pinned|driven", AT(motion),
     "free: forces move it; prescribed: keeps vx, vy, spin; orbit: circles, keeps spin; pinned: keeps vx, vy; driven: "
     "keeps spin"},
    {"orbit", TR_REAL, TR_DIM_SPIN, "rad/s", "0", -1e9, 1e9, NULL, AT(orbit),
     "rate of `motion: orbit` about (orbit_x, orbit_y), counter-clockwise"},
    {"orbit_x", TR_REAL, TR_DIM_LENGTH, "m", "0", -1e6, 1e6, NULL, AT(orbit_x), "centre of the orbit"},
    {"orbit_y", TR_REAL, TR_DIM_LENGTH, "m", "0", -1e6, 1e6, NULL, AT(orbit_y), "centre of the orbit"},
};
#undef STRUCT

#define STRUCT tr_scene_pull
static const tr_param pull[] = {
    {"force", TR_REAL, TR_DIM_FORCE, "N/m|N", NULL, -1e15, 1e15, NULL, AT(force), "given force of a thread"},
    {"angle", TR_REAL, TR_DIM_NUMBER, "rad", "0", -1e3, 1e3, NULL, AT(angle),
     "its direction, counter-clockwise from x"},
    {"radius", TR_REAL, TR_DIM_LENGTH, "m", "0", -1e3, 1e3, NULL, AT(radius),
     "of the hub that it leaves; above 0 it turns the disk counter-clockwise: pulled to the right, from below"},
};
#undef STRUCT

#define STRUCT tr_scene_wall
static const tr_param wall[] = {
    {"x", TR_REAL, TR_DIM_LENGTH, "m", "0", -1e6, 1e6, NULL, AT(x), "a point of the plane"},
    {"y", TR_REAL, TR_DIM_LENGTH, "m", "0", -1e6, 1e6, NULL, AT(y), "a point of the plane"},
    {"nx", TR_REAL, TR_DIM_NUMBER, "1", NULL, -1e6, 1e6, NULL, AT(nx), "normal, to the side of the disks; any length"},
    {"ny", TR_REAL, TR_DIM_NUMBER, "1", NULL, -1e6, 1e6, NULL, AT(ny), "normal, to the side of the disks; any length"},
    {"vx", TR_REAL, TR_DIM_SPEED, "m/s", "0", -1e6, 1e6, NULL, AT(vx), "velocity"},
    {"vy", TR_REAL, TR_DIM_SPEED, "m/s", "0", -1e6, 1e6, NULL, AT(vy), "velocity"},
    {"from", TR_REAL, TR_DIM_LENGTH, "m", "-1e6", -TR_ENDLESS, TR_ENDLESS, NULL, AT(from),
     "where it begins, from (x, y) along the wall, to the right where the normal points up; -1e6: endless"},
    {"to", TR_REAL, TR_DIM_LENGTH, "m", "1e6", -TR_ENDLESS, TR_ENDLESS, NULL, AT(to),
     "where it ends, likewise; 1e6: endless"},
    {"belt", TR_REAL, TR_DIM_SPEED, "m/s", "0", -1e6, 1e6, NULL, AT(belt),
     "speed of its surface from `from` to `to`: a conveyor belt, which stays where it is"},
};
#undef STRUCT

#define STRUCT tr_scene_check
#define NEXT_CHOICE(choice, name, ...) "|" name
static const tr_param check[] = {
    {"what", TR_CHOICE, TR_DIM_NUMBER, "", NULL, 0, 0, &TR_WHATS(NEXT_CHOICE)[1], AT(what), "the measured quantity"},
};
static const tr_param check_contact[] = {
    {"contact", TR_CONTACT_IDS, TR_DIM_NUMBER, "", NULL, 0, 1, NULL, AT(contact),
     "the contact: 0-1 (two disks), wall0-1 (wall 0, disk 1)"},
};
static const tr_param check_disk[] = {
    {"disk", TR_COUNT, TR_DIM_NUMBER, "", "0", 0, 1e3, NULL, AT(disk), "the disk"},
};
static const tr_param check_time[] = {
    {"at", TR_REAL, TR_DIM_TIME, "s", "time_end", 0, 1e6, NULL, AT(at), "time of the measurement"},
    {"over", TR_REAL, TR_DIM_TIME, "s", "0", 0, 1e6, NULL, AT(over),
     "mean over this time before `at`; 0: the value at that instant"},
};
#define EXACT(choice, dim, unit)                                                                                       \
    static const tr_param exact_##choice[] = {                                                                         \
        {"exact", TR_REAL, TR_DIM_##dim, unit, NULL, -1e30, 1e30, NULL, AT(exact), "the closed form"},                 \
        {"tolerance", TR_REAL, TR_DIM_##dim, unit, NULL, 1e-30, 1e30, NULL, AT(tolerance),                             \
         "largest |measured - exact|"},                                                                                \
    };
#define CLOSED_FORM(choice, name, dim, unit, ...) EXACT(choice, dim, unit)
TR_WHATS(CLOSED_FORM)
#define NEXT_COLUMN(name, ...) "|" #name
static const tr_param check_law[] = {
    {"what", TR_CHOICE, TR_DIM_NUMBER, "", NULL, 0, 0, &TR_COLUMNS(NEXT_COLUMN)[1], AT(what),
     "what is measured: a column of contact.csv"},
    {"law", TR_COUNT, TR_DIM_NUMBER, "", "0", 0, TR_MAX_LAWS - 1, NULL, AT(law), "of which item of `laws`, from 0"},
};
static const tr_param check_patch[] = {
    {"what", TR_CHOICE, TR_DIM_NUMBER, "", NULL, 0, 0, &TR_COLUMNS(NEXT_COLUMN) TR_PATCH_COLUMNS(NEXT_COLUMN)[1],
     AT(what), "what is measured: a column of contact.csv"},
};
static const tr_param check_segment[] = {
    {"segment", TR_COUNT, TR_DIM_NUMBER, "", "-1", -1, 1e9, NULL, AT(segment),
     "at the end of which segment of the path, from 0; -1: the last. Of a file: of which row"},
};
TR_COLUMNS(EXACT)
TR_PATCH_COLUMNS(EXACT)
#define BIT_OF_CONTACT(choice, name, dim, unit, whose, ...) | (whose == TR_OF_CONTACT) << choice
#define BIT_OF_DISK(choice, name, dim, unit, whose, ...) | (whose != TR_OF_CONTACT) << choice
#define BIT_AT_TIME(choice, name, dim, unit, whose, when, ...) | (when == TR_AT_TIME || when == TR_SINCE) << choice
#undef STRUCT

#define STRUCT tr_scene_pair
static const tr_param pair[] = {
    {"R1", TR_REAL, TR_DIM_LENGTH, "m", NULL, 1e-9, 1e3, NULL, AT(R1), "radius of body 1"},
    {"R2", TR_REAL, TR_DIM_LENGTH, "m", NULL, 1e-9, 1e3, NULL, AT(R2), "radius of body 2"},
    {"E", TR_REAL, TR_DIM_MODULUS, "Pa", NULL, 1e-3, 1e15, NULL, AT(E), "Young's modulus of both bodies"},
    {"nu", TR_REAL, TR_DIM_NUMBER, "1", NULL, -0.999, 0.5, NULL, AT(nu), "Poisson's ratio of both bodies"},
};
static const tr_param pair_density[] = {
    {"density", TR_REAL, TR_DIM_DENSITY, "kg/m^3", "0", 0, 1e6, NULL, AT(density),
     "density of both bodies, for laws that use inertia; 0: not given"},
};
#undef STRUCT

#define STRUCT tr_scene_contact
static const tr_param laws[] = {
    {"normal", TR_CHOICE, TR_DIM_NUMBER, "", "hertz-line|hertz-sphere", 0, 0, NULL, AT(normal.law),
     "law of the normal force: it links force and overlap"},
    {"friction", TR_CHOICE, TR_DIM_NUMBER, "", "none", 0, 0, NULL, AT(friction.law), "law of the friction force"},
    {"rolling", TR_CHOICE, TR_DIM_NUMBER, "", "none", 0, 0, NULL, AT(rolling.law), "law of the rolling resistance"},
    {"rolling_velocity", TR_CHOICE, TR_DIM_NUMBER, "", "wang", 0, 0, NULL, AT(rolling_velocity),
     "definition of the rolling velocity"},
};
#undef STRUCT

#define STRUCT tr_scene_segment
static const tr_param path[] = {
    {"force", TR_REAL, TR_DIM_FORCE, "N/m|N", NULL, 0, 1e12, "overlap", AT(force),
     "normal force at the end of the segment, linear up to there; constant in the first segment"},
    {"slide", TR_REAL, TR_DIM_LENGTH, "m", "0", -1e3, 1e3, "tangential", AT(slide), "int Vs dt over the segment"},
    {"roll", TR_REAL, TR_DIM_LENGTH, "m", "0", -1e3, 1e3, NULL, AT(roll), "-int (s1 + s2)/2 dt over the segment"},
    {"steps", TR_COUNT, TR_DIM_NUMBER, "", "100", 1, 1e6, NULL, AT(steps), "steps of the segment"},
};
static const tr_param path_contact[] = {
    {"overlap", TR_REAL, TR_DIM_LENGTH, "m", NULL, -1e3, 1e3, "force", AT(overlap),
     "overlap at the end of the segment, in place of force; 0 or less: the contact opens"},
    {"time", TR_REAL, TR_DIM_TIME, "s", "0", 0, 1e9, NULL, AT(time),
     "duration, for laws that depend on the rate; 0: not given"},
};
static const tr_param path_patch[] = {
    {"tangential", TR_REAL, TR_DIM_FORCE, "N/m|N", NULL, -1e12, 1e12, "slide", AT(tangential),
     "friction force at the end of the segment, linear up to there, in place of slide"},
};
#undef STRUCT

/* At the start of a segment. */
static const tr_param path_start[] = {
    {"P", TR_REAL, TR_DIM_FORCE, "N/m|N", "previous.force", 0, 1e12, NULL, 0, "normal force"},
    {"a", TR_REAL, TR_DIM_LENGTH, "m", "sqrt(4*P*R_star/(pi*E_star))|(3*P*R_star/(4*E_star))^(1/3)", 1e-15, 1e6, NULL,
     0, "half-width of the contact of disks, or radius of the contact of spheres"},
};

#define STRUCT tr_scene
#define SECTION(key_, doc_, kinds_, rows, ...)                                                                         \
    { .key = key_, .doc = doc_, .kinds = kinds_, .params = rows, .n = sizeof rows / sizeof *rows, __VA_ARGS__ }
#define LIST(array, count_, least, most)                                                                               \
    .offset = AT(array), .item = sizeof *((tr_scene *)0)->array, .count = AT(count_), .min_items = least,              \
    .max_items = most
#define CHECKS(kinds, rows, chosen_)                                                                                   \
    SECTION("checks", "numbers compared with closed forms", kinds, rows, LIST(checks, n_checks, 0, TR_MAX_CHECKS),     \
            .chosen = chosen_)
#define AND_EXACT(choice, ...) , CHECKS(TR_FOR_BODIES, exact_##choice, 1u << choice)
#define AND_COLUMN(name, ...) , CHECKS(TR_FOR_PAIR, exact_##name, 1u << TR_COLUMN_##name)
#define AND_PATCH_COLUMN(name, ...) , CHECKS(TR_FOR_PATCH, exact_##name, 1u << TR_COLUMN_##name)
const tr_section tr_sections[] = {
    SECTION("", "", TR_FOR_ALL, root, .offset = 0),
    SECTION("", "", TR_FOR_WORLDS, root_worlds, .offset = 0),
    SECTION("", "", TR_FOR_BIAXIAL, root_biaxial, .offset = 0),
    SECTION("", "", TR_FOR_BODIES, root_bodies, .offset = 0),
    SECTION("", "", TR_FOR_PATCH, root_patch, .offset = 0),
    SECTION("", "", TR_FOR_ALL, root_language, .offset = 0),
    SECTION("", "", TR_FOR_PAIR, root_pair, .offset = 0, .derived = true),
    SECTION("", "", TR_FOR_CONTACT, root_contact, .offset = 0, .derived = true),
    SECTION("lesson", "texts for the class", TR_FOR_ALL, lesson, .offset = AT(lesson),
            .example = "lesson: {title: what there is to see}"),
    SECTION("sample", "disks before compaction", TR_FOR_BIAXIAL, sample, .offset = AT(sample)),
    SECTION("contact", "the laws between two disks", TR_FOR_WORLDS, contact, .offset = AT(contact),
            .first_law_kind = 1),
    SECTION("compaction", "isotropic, between four smooth walls or in a periodic cell", TR_FOR_BIAXIAL, compaction,
            .offset = AT(compaction)),
    SECTION("shear", "top and bottom approach, the lateral sides hold the pressure", TR_FOR_BIAXIAL, shear,
            .offset = AT(shear)),
    SECTION("gravity", "", TR_FOR_BODIES, gravity, .offset = AT(gravity), .example = "gravity: {y: -9.81 m/s^2}"),
    SECTION("step", "time step", TR_FOR_BODIES, step_bodies, .offset = AT(step)),
    SECTION("step", "time step", TR_FOR_BIAXIAL, step_biaxial, .offset = AT(step)),
    SECTION("step", "time step", TR_FOR_WORLDS, step, .offset = AT(step)),
    SECTION("output", "what the run writes", TR_FOR_WORLDS, output, .offset = AT(output)),
    SECTION("output", "", TR_FOR_BIAXIAL, output_biaxial, .offset = AT(output)),
    SECTION("output", "", TR_FOR_BODIES, output_bodies, .offset = AT(output)),
    SECTION("output", "what the run writes", TR_FOR_PATCH, output_patch, .offset = AT(patch)),
    SECTION("output", "what the run writes", TR_FOR_BIAXIAL | TR_FOR_PAIR, output_curves, .offset = AT(output)),
    SECTION("disks", "", TR_FOR_BODIES, disk, LIST(disks, n_disks, 1, 1000)),
    SECTION("pull", "a thread that is wound on a hub", TR_FOR_BODIES, pull, .inside = "disks",
            .offset = offsetof(tr_scene_disk, pull), .given = offsetof(tr_scene_disk, pull.given)),
    SECTION("walls", "rigid planes", TR_FOR_BODIES, wall, LIST(walls, n_walls, 0, 100)),
    SECTION("contact", "laws of this wall; without a key, that of the contact of the scene holds", TR_FOR_BODIES,
            contact, .inside = "walls", .offset = offsetof(tr_scene_wall, contact),
            .given = offsetof(tr_scene_wall, own), .like = "contact", .first_law_kind = 1),
    CHECKS(TR_FOR_BODIES, check, 0),
    CHECKS(TR_FOR_BODIES, check_contact, 0 TR_WHATS(BIT_OF_CONTACT)),
    CHECKS(TR_FOR_BODIES, check_disk, 0 TR_WHATS(BIT_OF_DISK)),
    CHECKS(TR_FOR_BODIES, check_time, 0 TR_WHATS(BIT_AT_TIME)) TR_WHATS(AND_EXACT),
    SECTION("bodies", "the two bodies in contact, of one material", TR_FOR_CONTACT, bodies_shape, .offset = 0),
    SECTION("bodies", "the two bodies in contact, of one material", TR_FOR_PAIR, pair, .offset = AT(pair)),
    SECTION("bodies", "", TR_FOR_CONTACT, pair_density, .offset = AT(pair)),
    SECTION("bodies", "", TR_FOR_CONTACT, bodies_depth, .offset = 0),
    SECTION("laws", "each item runs along the path on its own", TR_FOR_CONTACT, laws,
            LIST(laws, n_laws, 1, TR_MAX_LAWS), .first_law_kind = 1),
    SECTION("path", "motion of the contact; the line of centres does not move", TR_FOR_PAIR, path,
            LIST(path, n_segments, 1, 1000), .file = AT(path_file)),
    SECTION("path", "", TR_FOR_CONTACT, path_contact, LIST(path, n_segments, 1, 1000)),
    SECTION("path", "", TR_FOR_PATCH, path_patch, LIST(path, n_segments, 1, 1000)),
    SECTION("path", "", TR_FOR_PAIR, path_start, LIST(path, n_segments, 1, 1000), .derived = true),
    CHECKS(TR_FOR_CONTACT, check_law, 0),
    CHECKS(TR_FOR_PATCH, check_patch, 0),
    CHECKS(TR_FOR_PAIR, check_segment, 0) TR_COLUMNS(AND_COLUMN) TR_PATCH_COLUMNS(AND_PATCH_COLUMN),
};
const int tr_n_sections = sizeof tr_sections / sizeof *tr_sections;

bool tr_tables_begins(int i, unsigned kind) {
    if (!(tr_sections[i].kinds & kind) || tr_sections[i].inside) return false;
    for (int k = i - 1; k >= 0 && strcmp(tr_sections[k].key, tr_sections[i].key) == 0; k--)
        if (tr_sections[k].kinds & kind) return false;
    return true;
}

int tr_tables_inside(const char *list, unsigned kind, int i) {
    for (i++; i < tr_n_sections; i++) {
        const tr_section *t = &tr_sections[i];
        if (t->inside && t->kinds & kind && strcmp(t->inside, list) == 0) break;
    }
    return i;
}

const tr_section *tr_tables_next(const tr_section *section, unsigned kind) {
    const tr_section *end = tr_sections + tr_n_sections;
    for (const tr_section *t = section + 1; t < end && strcmp(t->key, section->key) == 0; t++)
        if (t->kinds & kind) return t;
    return NULL;
}

bool tr_tables_chosen(const tr_section *section, const void *item) {
    return !section->chosen || section->chosen >> *(const int *)item & 1;
}

#undef STRUCT

#define STRUCT tr_scene_contact
tr_law_place tr_tables_law_kind(const tr_param_catalog *catalog, int i) {
    const tr_law_place slots[TR_LAW_KINDS] = {
        {"normal", catalog->normal, catalog->n_normal, AT(normal)},
        {"friction", catalog->friction, catalog->n_friction, AT(friction)},
        {"rolling", catalog->rolling, catalog->n_rolling, AT(rolling)},
    };
    return slots[i];
}
#undef STRUCT

/* Choice i of "a|b|c". */
static bool choice_of(const char *p, int i, tr_shown *name) {
    for (; i > 0; i--) {
        p = strchr(p, '|');
        if (!p) return false;
        p++;
    }
    char text[sizeof name->text];
    snprintf(text, sizeof text, "%.*s", (int)strcspn(p, "|"), p);
    *name = tr_text_show(text);
    return true;
}

bool tr_tables_choice(const tr_param_catalog *catalog, const tr_param *param, int i, tr_shown *name) {
    if (param->choices) return choice_of(param->choices, i, name);
    for (int k = 0; k < TR_LAW_KINDS; k++) {
        tr_law_place slot = tr_tables_law_kind(catalog, k);
        if (strcmp(param->key, slot.key) != 0) continue;
        if (i < slot.n) *name = tr_text_show(slot.laws[i]->name);
        return i < slot.n;
    }
    return choice_of(strcmp(param->key, "arms") ? catalog->rolling_velocities : catalog->arms, i, name);
}
