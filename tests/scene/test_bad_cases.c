/* SPDX-License-Identifier: MIT */
/* Wrong cases and the whole message each one gets: place, what is wrong, what is allowed, the line, the caret. */
#include "assert_close.h"
#include "fake_catalog.h"

#define GOOD                                                                                                           \
    "kind: biaxial\n"                                                                                                  \
    "sample: {r_min: 1 mm, r_max: 2 mm}\n"                                                                             \
    "contact: {k_n: 1 MPa}\n"                                                                                          \
    "compaction: {pressure: 1 kPa}\n"
#define PAIR "kind: contact\nbodies: {R1: 10 mm, R2: 10 mm, E: 70 GPa, nu: 0.3}\n"
#define BALLS "kind: contact\nbodies: {R1: 10 mm, R2: 10 mm, E: 70 GPa, nu: 0.3, shape: sphere}\n"
#define LAWS "laws: [{friction: coulomb-spring, k_t: E_star}]\n"
#define ROLL PAIR LAWS "path: [{force: 1 kN/m}]\n"
#define NO_DISKS "kind: bodies\ntime_end: 1 s\ncontact: {k_n: 1 MPa}\n"
#define GOOD_BODIES NO_DISKS "disks: [{radius: 1, x: 0, y: 0}]\n"

typedef struct bad_case {
    const char *text;
    size_t size; /* 0: up to the NUL */
    const char *set, *message;
} bad_case;

static const bad_case rows[] = {
    {"", 0, NULL, "a.yaml:1:1: error: the file is empty; a case begins with `kind:`\n\n^"},
    {"# only a comment\n", 0, NULL,
     "a.yaml:1:1: error: the file is empty; a case begins with `kind:`\n# only a comment\n^"},
    {"- a\n- b\n", 0, NULL, "a.yaml:1:1: error: a case must be a mapping of keys and values\n- a\n^"},
    {"kind: biaxial\n\011seed: 1\n", 0, NULL, "a.yaml:2:1: error: tabs are not allowed; use spaces\n seed: 1\n^"},
    {"kind: bi\000axial\n", 15, NULL,
     "a.yaml:1:9: error: character U+0000 is not allowed; a case is a text file\nkind: bi?axial\n        ^"},
    {"kind: \377\376\n", 0, NULL,
     "a.yaml:1:7: error: byte 0xff is not UTF-8; a case is a text file\nkind: ??\n      ^"},
    {"kind: biaxial\nseed: \033[31m\n", 0, NULL,
     "a.yaml:2:7: error: character U+001B is not allowed; a case is a text file\nseed: ?[31m\n      ^"},
    {"kind: &a biaxial\n", 0, NULL,
     "a.yaml:1:7: error: anchors (&name) are not allowed; write the value out\nkind: &a biaxial\n      ^"},
    {"kind: biaxial\nseed: *a\n", 0, NULL,
     "a.yaml:2:7: error: aliases (*name) are not allowed; write the value out\nseed: *a\n      ^"},
    {"kind: !!str biaxial\n", 0, NULL, "a.yaml:1:7: error: tags (!name) are not allowed\nkind: !!str biaxial\n      ^"},
    {"%TAG ! tag:x,2000:\n---\nkind: biaxial\n", 0, NULL,
     "a.yaml:1:1: error: tags (%TAG) are not allowed\n%TAG ! tag:x,2000:\n^"},
    {GOOD "---\nkind: bodies\n", 0, NULL, "a.yaml:5:1: error: a second document (---) is not allowed\n---\n^"},
    {"kind: biaxial\nseed: 1\nkind: bodies\n", 0, NULL,
     "a.yaml:3:1: error: duplicate key `kind`; it is already given in line 1\nkind: bodies\n^"},
    {"kind: biaxial\nsample: {disks: 4\n", 0, NULL,
     "a.yaml:3:1: error: not valid YAML: did not find expected ',' or '}', while parsing a flow mapping that begins in "
     "line 2\n\n^"},
    {"kind: biaxial\n seed: 1\n", 0, NULL,
     "a.yaml:2:6: error: not valid YAML: mapping values are not allowed in this context\n seed: 1\n     ^"},
    {"kind: biaxial\n[a]: 1\n", 0, NULL, "a.yaml:2:1: error: a key must be plain text\n[a]: 1\n^"},
    {"seed: 1\n", 0, NULL,
     "a.yaml:1:1: error: `kind` is missing: what is simulated: a biaxial test, a few bodies, one contact along a path, "
     "or the inside of one\nseed: 1\n^"},
    {"kind: triaxial\n", 0, NULL,
     "a.yaml:1:7: error: `triaxial` is not a choice for `kind` (did you mean `biaxial`?); allowed is biaxial | bodies "
     "| contact | patch\nkind: triaxial\n      ^"},
    {"kind: biaxal\n", 0, NULL,
     "a.yaml:1:7: error: `biaxal` is not a choice for `kind` (did you mean `biaxial`?); allowed is biaxial | bodies | "
     "contact | patch\nkind: biaxal\n      ^"},
    {"kind: [biaxial]\n", 0, NULL,
     "a.yaml:1:7: error: `kind` must be a single value: what is simulated: a biaxial test, a few bodies, one contact "
     "along a path, or the inside of one\nkind: "
     "[biaxial]\n      ^"},
    {GOOD "smaple: {disks: 4}\n", 0, NULL,
     "a.yaml:5:1: error: unknown key `smaple` (did you mean `sample`?); allowed here: kind, shape, seed, boundary, "
     "language, lesson, "
     "sample, "
     "contact, "
     "compaction, shear, step, output\nsmaple: {disks: 4}\n^"},
    {GOOD "frobnicate: 3\n", 0, NULL,
     "a.yaml:5:1: error: unknown key `frobnicate`; allowed here: kind, shape, seed, boundary, language, lesson, "
     "sample, contact, "
     "compaction, "
     "shear, step, "
     "output\nfrobnicate: 3\n^"},
    {GOOD "gravity: {y: -9.81}\n", 0, NULL,
     "a.yaml:5:1: error: `gravity` is not for `kind: biaxial`; allowed here: kind, shape, seed, boundary, language, "
     "lesson, "
     "sample, "
     "contact, "
     "compaction, "
     "shear, step, output\ngravity: {y: -9.81}\n^"},
    {GOOD_BODIES "seed: 3\n", 0, NULL, /* nothing is random there */
     "a.yaml:5:1: error: `seed` is not for `kind: bodies`; allowed here: kind, shape, time_end, label, language, "
     "lesson, "
     "contact, gravity, "
     "step, "
     "output, disks, walls, checks\nseed: 3\n^"},
    {GOOD_BODIES "output: {energy: yes}\n", 0, NULL,
     "a.yaml:5:10: error: `output.energy` is not for `kind: bodies`; allowed here: frames, rows, contacts, paths, "
     "curve, contact, still, view\noutput: {energy: yes}\n         ^"},
    {GOOD "output: {color: mobilization}\n", 0, NULL,
     "a.yaml:5:17: error: `mobilization` is not a choice for `color` (did you mean `mobilisation`?); allowed is "
     "mobilisation | sliding | rolling | slip | spin | motion\noutput: {color: mobilization}\n                ^"},
    {GOOD_BODIES "lesson: {title: \"0123456789012345678901234567890123456789012345678901234567890\u00e4b\"}\n", 0, NULL,
     "a.yaml:5:17: error: `title` is 64 bytes of UTF-8 long, allowed is 63\nlesson: {title: "
     "\"0123456789012345678901234567890123456789012345678901234567890\u00e4b\"}\n                ^"},
    {GOOD "lesson:\n  title: Rolling\n  question: \"a\\x1b[31mb\"\n", 0, NULL, /* YAML's escapes bring it in */
     "a.yaml:7:13: error: `question` holds a character that is not allowed; it is a line of text\n  question: "
     "\"a\\x1b[31mb\"\n            ^"},
    {GOOD "lesson: {answer: [1, 2]}\n", 0, NULL,
     "a.yaml:5:18: error: `lesson.answer` must be a single value: answer to the question\nlesson: {answer: [1, 2]}\n   "
     "   "
     "           ^"},
    {GOOD "label: a\n", 0, NULL,
     "a.yaml:5:1: error: `label` is not for `kind: biaxial`; allowed here: kind, shape, seed, boundary, language, "
     "lesson, "
     "sample, contact, "
     "compaction, shear, step, output\nlabel: a\n^"},
    {"just words", 0, "seed=3", "a.yaml:1:1: error: a case must be a mapping of keys and values\njust words\n^"},
    {GOOD "output: {energy: maybe}\n", 0, NULL,
     "a.yaml:5:18: error: `maybe` is not a choice for `energy`; allowed is yes | no\noutput: {energy: maybe}\n         "
     "        ^"},
    {"kind: biaxial\ncontact: {k_n: 1}\ncompaction: {pressure: 1}\nsample:\n  r_min: 1 mm\n", 0, NULL,
     "a.yaml:5:3: error: `sample.r_max` is missing: largest radius [m]; or give file\n  r_min: 1 mm\n  ^"},
    {"kind: biaxial\nsample: {r_min: 1, r_max: 1}\ncontact: {k_n: 1}\n", 0, NULL,
     "a.yaml:3:18: error: `compaction.pressure` is missing: pressure on all four walls [Pa]\ncontact: {k_n: 1}\n       "
     "          ^"},
    {"kind: biaxial\nsample: {r_min: 1 kPa, r_max: 2 mm}\ncontact: {k_n: 1 MPa}\ncompaction: {pressure: 1 kPa}\n", 0,
     NULL,
     "a.yaml:2:17: error: wrong dimension: this is in kg m^-1 s^-2 (`r_min` is in m)\nsample: {r_min: 1 kPa, r_max: 2 "
     "mm}\n                ^"},
    {"kind: biaxial\nsample: {r_min: 1   mx, r_max: 2 mm}\ncontact: {k_n: 1 MPa}\ncompaction: {pressure: 1 kPa}\n", 0,
     NULL,
     "a.yaml:2:21: error: unknown name `mx`; a name is a key of this mapping, section.key, or a unit: kg g t m mm cm "
     "um km s ms us min N kN MN Pa kPa MPa GPa J deg rad rpm (`r_min` is in m)\nsample: {r_min: 1   mx, r_max: 2 mm}\n "
     " "
     "                  ^"},
    {"kind: biaxial\nsample: {r_min: r_mix, r_max: 2 mm}\ncontact: {k_n: 1 MPa}\ncompaction: {pressure: 1 kPa}\n", 0,
     NULL,
     "a.yaml:2:17: error: unknown name `r_mix` (did you mean `r_min`?); a name is a key of this mapping, section.key, "
     "or a unit: kg g t m mm cm um km s ms us min N kN MN Pa kPa MPa GPa J deg rad rpm (`r_min` is in m)\nsample: "
     "{r_min: r_mix, r_max: 2 mm}\n                ^"},
    {"kind: biaxial\nsample: {r_min: 3 mm, r_max: 2 mm}\ncontact: {k_n: 1 MPa}\ncompaction: {pressure: 1 kPa}\n", 0,
     NULL,
     "a.yaml:2:10: error: `sample.r_min` is 0.003 m, more than `sample.r_max`, which is 0.002 m\nsample: {r_min: 3 mm, "
     "r_max: 2 mm}\n         ^"},
    {"kind: biaxial\nsample: {r_min: -1 mm, r_max: 2 mm}\ncontact: {k_n: 1 MPa}\ncompaction: {pressure: 1 kPa}\n", 0,
     NULL,
     "a.yaml:2:17: error: `r_min` is -0.001, allowed is 1e-09 to 1000 m\nsample: {r_min: -1 mm, r_max: 2 mm}\n         "
     "       ^"},
    {"kind: biaxial\nsample: {r_min: , r_max: 2 mm}\ncontact: {k_n: 1 MPa}\ncompaction: {pressure: 1 kPa}\n", 0, NULL,
     "a.yaml:2:17: error: `sample.r_min` has no value: smallest radius; radii are uniform from r_min to r_max\nsample: "
     "{r_min: , "
     "r_max: 2 mm}\n                ^"},
    {"kind: biaxial\nsample: {r_min: 1 mm;, r_max: 2 mm}\ncontact: {k_n: 1 MPa}\ncompaction: {pressure: 1 kPa}\n", 0,
     NULL,
     "a.yaml:2:21: error: this character cannot stand in a value; allowed are numbers, names, + - * / ^ ( ) (`r_min` "
     "is in m)\nsample: {r_min: 1 mm;, r_max: 2 mm}\n                    ^"},
    {"kind: biaxial\nsample: {r_min: sample.r_min, r_max: 2 mm}\ncontact: {k_n: 1 MPa}\ncompaction: {pressure: 1 "
     "kPa}\n",
     0, NULL,
     "a.yaml:2:17: error: these keys refer to each other in a circle: sample.r_min -> sample.r_min\nsample: {r_min: "
     "sample.r_min, r_max: 2 mm}\n                ^"},
    {"kind: biaxial\nsample: {r_min: 1e400, r_max: 2 mm}\ncontact: {k_n: 1 MPa}\ncompaction: {pressure: 1 kPa}\n", 0,
     NULL,
     "a.yaml:2:17: error: the result is not a finite number (`r_min` is in m)\nsample: {r_min: 1e400, r_max: 2 mm}\n   "
     "             ^"},
    {"kind: biaxial\nsample: {r_min: .nan, r_max: 2 mm}\ncontact: {k_n: 1 MPa}\ncompaction: {pressure: 1 kPa}\n", 0,
     NULL,
     "a.yaml:2:17: error: expected a number, a unit, a key or `(` here (`r_min` is in m)\nsample: {r_min: .nan, r_max: "
     "2 mm}\n                ^"},
    {"kind: biaxial\nsample: {r_min: r_max, r_max: 0.5*r_min}\ncontact: {k_n: 1 MPa}\ncompaction: {pressure: 1 kPa}\n",
     0, NULL,
     "a.yaml:2:31: error: these keys refer to each other in a circle: sample.r_min -> sample.r_max -> "
     "sample.r_min\nsample: {r_min: r_max, r_max: 0.5*r_min}\n                              ^"},
    {"kind: biaxial\nsample: {r_min: kind, r_max: 2 mm}\ncontact: {k_n: 1 MPa}\ncompaction: {pressure: 1 kPa}\n", 0,
     NULL,
     "a.yaml:2:17: error: `kind` is not a quantity (`r_min` is in m)\nsample: {r_min: kind, r_max: 2 mm}\n             "
     "   ^"},
    {"kind: biaxial\nsample: {r_min: "
     "11111111111111111111111111111111111111111111111111111111111111111111111111111111111111111111111111111111111111111"
     "1111111111111111111111111111111111111111111111111111111111111111111111111111111111111111, r_max: 2 mm}\ncontact: "
     "{k_n: 1 MPa}\ncompaction: {pressure: 1 kPa}\n",
     0, NULL,
     "a.yaml:2:17: error: this value is longer than 200 characters (`r_min` is in m)\nsample: {r_min: "
     "111111111111111111111111111111111111111111111111111111111111111111111111111111111111\n                ^"},
    {GOOD "step: {safety: 1.5}\n", 0, NULL,
     "a.yaml:5:16: error: `safety` is 1.5, allowed is 1e-06 to 1\nstep: {safety: 1.5}\n               ^"},
    {GOOD "step: 3\n", 0, NULL, "a.yaml:5:7: error: `step` must be a mapping of keys and values\nstep: 3\n      ^"},
    {GOOD "output: {frames: 2.5}\n", 0, NULL,
     "a.yaml:5:18: error: `frames` must be a whole number, 0 to 100000\noutput: {frames: 2.5}\n                 ^"},
    {GOOD "output: {frames: 100001}\n", 0, NULL,
     "a.yaml:5:18: error: `frames` is 100001, allowed is 0 to 100000\noutput: {frames: 100001}\n                 ^"},
    {GOOD "seed: -1\n", 0, NULL,
     "a.yaml:5:7: error: `seed` must be a whole number, 0 to 18446744073709551615\nseed: -1\n      ^"},
    {GOOD "seed: 18446744073709551616\n", 0, NULL,
     "a.yaml:5:7: error: `seed` must be a whole number, 0 to 18446744073709551615\nseed: 18446744073709551616\n      "
     "^"},
    {"kind: biaxial\nsample: {r_min: 1 mm, r_max: 2 mm}\ncontact: {k_n: 1 MPa, friction: none}\ncompaction: {pressure: "
     "1 kPa}\n",
     0, NULL,
     "a.yaml:3:10: error: `contact.k_r` is not given, and its default `k_t` fails: `k_t` belongs to the law "
     "coulomb-spring, which is not chosen (`k_r` is in Pa); give `k_r`\ncontact: {k_n: 1 MPa, friction: none}\n        "
     " ^"},
    {"kind: biaxial\nsample: {r_min: 1 mm, r_max: 2 mm}\ncontact: {k_n: 1 MPa, k_t: 2*k_r}\ncompaction: {pressure: 1 "
     "kPa}\n",
     0, NULL,
     "a.yaml:3:10: error: `contact.k_r` is not given, and its default `k_t` fails: these keys refer to each other in a "
     "circle: contact.k_t -> contact.k_r -> contact.k_t; give `k_r`\ncontact: {k_n: 1 MPa, k_t: 2*k_r}\n         ^"},
    {"kind: biaxial\nsample: {r_min: 1 mm, r_max: 2 mm}\ncontact: {k_n: 1 MPa, normal: liner}\ncompaction: {pressure: "
     "1 kPa}\n",
     0, NULL,
     "a.yaml:3:31: error: `liner` is not a choice for `normal` (did you mean `linear`?); allowed is linear | sticky | "
     "hertz-line | hertz-sphere\ncontact: {k_n: 1 MPa, normal: liner}\n                              ^"},
    {"kind: biaxial\nsample: {r_min: 1 mm, r_max: 2 mm}\ncontact: {k_n: 1 MPa, rolling: old-spring}\ncompaction: "
     "{pressure: "
     "1 kPa}\n",
     0, NULL,
     "a.yaml:3:32: error: `old-spring` has another name now: write `rolling: wang-spring`\ncontact: {k_n: 1 MPa, "
     "rolling: old-spring}\n                               ^"},
    {"kind: biaxial\nsample: {r_min: 1 mm, r_max: 2 mm}\ncontact: {k_n: 1 MPa, rolling: none, k_r: 3 mm}\ncompaction: "
     "{pressure: 1 kPa}\n",
     0, NULL,
     "a.yaml:3:43: error: wrong dimension: this is in m (`k_r` is in Pa)\ncontact: {k_n: 1 MPa, rolling: none, k_r: 3 "
     "mm}\n                                          ^"},
    {"kind: biaxial\nsample: {r_min: 1 mm, r_max: 2 mm}\ncontact: {k_n: 1 MPa, k_m: 3}\ncompaction: {pressure: 1 "
     "kPa}\n",
     0, NULL,
     "a.yaml:3:23: error: unknown key `contact.k_m` (did you mean `k_n`?); allowed here: normal, friction, rolling, "
     "rolling_velocity, arms, k_n, damping_ratio, mu, k_t, mu_r, k_r, layers, wet, model, E_star, depth, "
     "step\ncontact: "
     "{k_n: 1 MPa, k_m: 3}\n    "
     "                  ^"},
    {"kind: biaxial\nsample: {r_min: 1 mm, r_max: 2 mm}\ncompaction: {pressure: 1 kPa}\n", 0, NULL,
     "a.yaml:3:30: error: `contact.k_n` is missing: stiffness k_n [Pa]\ncompaction: {pressure: 1 kPa}\n                "
     "             ^"},
    {NO_DISKS, 0, NULL,
     "a.yaml:3:22: error: `disks` has 0 items, allowed is 1 to 1000\ncontact: {k_n: 1 MPa}\n                     ^"},
    {NO_DISKS "disks: {radius: 1}\n", 0, NULL,
     "a.yaml:4:8: error: `disks` must be a list, one `- key: value` for each\ndisks: {radius: 1}\n       ^"},
    {NO_DISKS "disks: [3]\n", 0, NULL,
     "a.yaml:4:9: error: `disks.0` must be a mapping of keys and values\ndisks: [3]\n        ^"},
    {NO_DISKS "disks:\n  - radius: 1\n    x: 0\n", 0, NULL,
     "a.yaml:5:5: error: `disks.0.y` is missing: centre at the start [m]\n  - radius: 1\n    ^"},
    {NO_DISKS "disks: []\n", 0, NULL,
     "a.yaml:4:8: error: `disks` has 0 items, allowed is 1 to 1000\ndisks: []\n       ^"},
    {NO_DISKS "disks: [{radius: 1, x: 0, y: 0, spin: 1 Hz}]\n", 0, NULL,
     "a.yaml:4:41: error: Hz is not a unit here: a turn a second is 2*pi*rad/s, not 1 rad/s; write rad/s, deg/s or rpm "
     "(1 Hz = 2*pi*rad/s = 360 deg/s = 60 rpm) (`spin` is in rad/s)\ndisks: [{radius: 1, x: 0, y: 0, spin: 1 Hz}]\n    "
     "                                    ^"},
    {GOOD_BODIES "walls: [{nx: 0, ny: 0}]\n", 0, NULL,
     "a.yaml:5:9: error: the normal (nx, ny) of `walls.0` is zero\nwalls: [{nx: 0, ny: 0}]\n        ^"},
    {GOOD, 0, "shear.inertial_numbr=1e-4",
     "--set:1:7: error: unknown key `shear.inertial_numbr` (did you mean `inertial_number`?); allowed here: "
     "lateral_pressure, hold, inertial_number, strain_end, walls\nshear.inertial_numbr=1e-4\n      ^"},
    {GOOD "boundary: periodic\nshear: {walls: rough}\n", 0, NULL,
     "a.yaml:6:16: error: `boundary: periodic` has no walls: `walls: rough` is not allowed\nshear: {walls: rough}\n    "
     "           ^"},
    {GOOD "shear: {hold: mean}\n", 0, NULL,
     "a.yaml:5:15: error: the lateral walls hold their own pressure: `hold: mean` takes `boundary: periodic`\nshear: "
     "{hold: mean}\n              ^"},
    {GOOD "boundary: periodic\noutput: {paths: [wall0-3]}\n", 0, NULL,
     "a.yaml:6:18: error: there is no contact `wall0-3`: disks count from 0 to 399, walls are 0\noutput: {paths: "
     "[wall0-3]}\n                 ^"},
    {GOOD, 0, "shear.inertial_number=1 mm",
     "--set:1:23: error: wrong dimension: this is in m (`inertial_number` is a number)\nshear.inertial_number=1 mm\n   "
     "                   ^"},
    {GOOD, 0, "shear.inertial_number",
     "--set:1:1: error: no `=`; write key=value, as in step.safety=0.2\nshear.inertial_number\n^"},
    {GOOD, 0, "=3", "--set:1:1: error: no key before `=`\n=3\n^"},
    {GOOD, 0, "shear..x=3",
     "--set:1:7: error: no key here; write key=value, as in step.safety=0.2\nshear..x=3\n      ^"},
    {GOOD, 0, "shear x=3", "--set:1:7: error: expected `.` or `=` here\nshear x=3\n      ^"},
    {GOOD, 0, "seed.x=3",
     "--set:1:1: error: `seed` must be a single value: start of the random numbers: same seed, same "
     "sample\nseed.x=3\n^"},
    {GOOD_BODIES, 0, "disks.1.x=3",
     "--set:1:7: error: `1` is not the number of an item; there are 1, counted from 0\ndisks.1.x=3\n      ^"},
    {NO_DISKS "disks: [3]\n", 0, "disks.0.x=3",
     "--set:1:9: error: `3` is a single value, it has no keys\ndisks.0.x=3\n        ^"},
    {GOOD_BODIES "---\nlabel: b\nstep: {dt: 1 ms}\n", 0, "step.safty=3", /* the first it is applied to */
     "--set:1:6: error: unknown key `step.safty` (did you mean `safety`?); allowed here: safety, dt, "
     "allow_unstable\nstep.safty=3\n     ^"},
    {GOOD, 0, "contact=3", "--set:1:9: error: `contact` must be a mapping of keys and values\ncontact=3\n        ^"},
    {GOOD, 0, "shear.strain_end=\0110.1",
     "--set:1:18: error: tabs are not allowed; use spaces\nshear.strain_end= 0.1\n                 ^"},
};

static void messages(void **state) {
    (void)state;
    int failed = 0;
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        const bad_case *row = &rows[i];
        tr_scene scene;
        tr_status st = {0};
        bool ok = tr_scene_read(&scene,
                                &(tr_scene_source){"a.yaml", row->text, row->size ? row->size : strlen(row->text),
                                                   &row->set, row->set ? 1 : 0},
                                &fake_catalog, &st);
        if (ok) fail_msg("accepted: %s", row->text);
        assert_int_equal(st.code, TR_BAD_CASE);
        if (strcmp(st.text, row->message) == 0) continue;
        print_message("case %zu says:\n%s\nexpected:\n%s\n\n", i, st.text, row->message);
        failed++;
    }
    assert_int_equal(failed, 0);
}

/* Size and depth, each just inside and just outside; and that depth is noticed at once, not after a megabyte of
 * brackets. */
static void limits(void **state) {
    (void)state;
    enum { MEGABYTE = 1 << 20 };
    static char text[MEGABYTE + 2];
    tr_scene scene;
    tr_status st;
    memset(text, '[', MEGABYTE);
    assert_false(fake_read(&scene, text, NULL, 0, &st));
    assert_non_null(strstr(st.text, "a.yaml:1:17: error: nested deeper than 16 levels\n[[[["));
    text[16] = '\0';
    assert_false(fake_read(&scene, text, NULL, 0, &st));
    assert_non_null(strstr(st.text, "not valid YAML"));
    memset(text, '#', sizeof text - 1);
    memcpy(text, GOOD, strlen(GOOD));
    text[MEGABYTE] = '\0';
    assert_true(fake_read(&scene, text, NULL, 0, &st));
    tr_scene_free(&scene);
    text[MEGABYTE] = '#';
    assert_false(fake_read(&scene, text, NULL, 0, &st));
    assert_non_null(
        strstr(st.text, "a.yaml:1:1: error: the text is longer than 1 MB; a case is a few kB\nkind: biaxial\n^"));
}

/* Two documents of 501 disks: the second inherits them. */
static void too_many_disks(void **state) {
    (void)state;
    static char text[40000] = NO_DISKS "disks:\n";
    tr_scene scene;
    tr_status st;
    for (int i = 0; i < 501; i++) strcat(text, "  - {radius: 1, x: 0, y: 0}\n");
    strcat(text, "---\nlabel: b\n");
    assert_false(fake_read(&scene, text, NULL, 0, &st));
    assert_non_null(strstr(
        st.text, "a.yaml:506:1: error: with this document there are 1002 disks, allowed is 1 to 1000 in all\n---\n^"));
}

/* A name of a file may be anything too, and a caret in a long line of wide characters still fits. */
static void long_lines(void **state) {
    (void)state;
    char text[3000] = "kind: ", name[3000];
    tr_scene scene;
    tr_status st = {0};
    for (int i = 0; i < 500; i++) strcat(text, "\xf0\x9f\x98\x80");
    strcat(text, "\t");
    memset(name, 'n', sizeof name);
    name[1] = '\n';
    name[sizeof name - 1] = '\0';
    assert_false(tr_scene_read(&scene, &(tr_scene_source){name, text, strlen(text), NULL, 0}, &fake_catalog, &st));
    assert_memory_equal(st.text, "n?n", 3);
    assert_non_null(strstr(st.text, "n:1:507: error: tabs are not allowed; use spaces\n"));
    char caret[128];
    snprintf(caret, sizeof caret, "\n%*s^", 70, ""); /* the line is shown from 70 characters before the column */
    assert_string_equal(strrchr(st.text, '\n'), caret);
}

/* Cases whose messages begin with `begins`. */
typedef struct begin_case {
    const char *text, *begins;
} begin_case;

static void assert_messages(const begin_case *rows, size_t n) {
    int failed = 0;
    for (size_t i = 0; i < n; i++) {
        tr_scene scene;
        tr_status st;
        if (fake_read(&scene, rows[i].text, NULL, 0, &st)) fail_msg("accepted: %s", rows[i].text);
        assert_int_equal(st.code, TR_BAD_CASE);
        const tr_scene empty = {0};
        assert_memory_equal(&scene, &empty, sizeof scene);
        if (strncmp(st.text, rows[i].begins, strlen(rows[i].begins)) == 0) continue;
        print_message("case %zu says:\n%s\nexpected:\n%s\n\n", i, st.text, rows[i].begins);
        failed++;
    }
    assert_int_equal(failed, 0);
}

/* What people write who come from elsewhere: the message says what to write here. */
static void habits_messages(void **state) {
    (void)state;
/* A text with a character of several bytes is told by its beginning. */
#define ONE_DISK "contact: {k_n: 1 MPa}\ndisks: [{radius: 1, x: 0, y: 0}]\n"
    static const begin_case rows[] = {
        {GOOD "step: {dt: 0,3}\n", "a.yaml:5:14: error: a number has a decimal point: write `dt: 0.3`\n"},
        {GOOD "step: {dt: 0,3, safety: 0,3}\n", "a.yaml:5:14: error: a number has a decimal point: write `dt: 0.3`\n"},
        {NO_DISKS "disks: [{radius: 0,5 mm, x: 0, y: 0}]\n",
         "a.yaml:4:20: error: a number has a decimal point: write `radius: 0.5 mm`\n"},
        {GOOD "step: {safety: 0.1, 3: 4}\n",
         "a.yaml:5:21: error: a number has a decimal point: write `safety: 0.1.3`\n"},
        {GOOD "step: {3: 4}\n", "a.yaml:5:8: error: unknown key `step.3`"},
        {"kind: bodies\ntime_end: 0,3 s\n" ONE_DISK,
         "a.yaml:2:12: error: `,` cannot stand in a value; a number has a decimal point, and nothing between "
         "thousands: write 0.3 for 0,3, and 1000 for 1,000 (`time_end` is in s)\n"},
        {"kind: bodies\ntime_end: 20% \n" ONE_DISK,
         "a.yaml:2:13: error: `%` cannot stand in a value; write 0.2 for 20 % ("},
        {"kind: bodies\ntime_end: 20 %\n" ONE_DISK,
         "a.yaml:2:14: error: `%` cannot stand in a value; write 0.2 for 20 % ("},
        {"kind: bodies\ntime_end: 10°\n" ONE_DISK,
         "a.yaml:2:11: error: `°` cannot stand in a value; write 10 deg for 10 ° ("},
        {"kind: bodies\ntime_end: 10 µs\n" ONE_DISK,
         "a.yaml:2:11: error: `µ` cannot stand in a value; write um for µm ("},
        {"kind: bodies\ntime_end: −1 s\n" ONE_DISK,
         "a.yaml:2:11: error: `−` cannot stand in a value; write - for the minus ("},
        {"kind: bodies\ntime_end: 2·3 s\n" ONE_DISK,
         "a.yaml:2:11: error: `·` cannot stand in a value; write * between factors ("},
        {"kind: bodies\ntime_end: 1 s²\n" ONE_DISK, "a.yaml:2:11: error: `²` cannot stand in a value; write ^2 ("},
        {"kind: bodies\ntime_end: 1 €\n" ONE_DISK,
         "a.yaml:2:11: error: this character cannot stand in a value; allowed are "},
        {GOOD "mu: 0.3\n", "a.yaml:5:1: error: unknown key `mu` (did you mean `contact.mu`?); allowed here: kind, "},
        {GOOD "frames: 3\n", "a.yaml:5:1: error: unknown key `frames` (did you mean `output.frames`?); allowed here: "},
        {GOOD "output: {r_min: 3}\n",
         "a.yaml:5:10: error: unknown key `output.r_min` (did you mean `sample.r_min`?); allowed here: frames, "},
        {GOOD_BODIES "radius: 3\n",
         "a.yaml:5:1: error: unknown key `radius` (did you mean `disks.0.radius`?); allowed "},
        {ROLL "slide: 3\n",
         "a.yaml:5:1: error: unknown key `slide` (did you mean `path.0.slide`?); allowed here: kind, "},
        {GOOD_BODIES "gravity: -9.81\n", "a.yaml:5:10: error: `gravity` must be a mapping of keys and values: write "
                                         "gravity: {y: -9.81 m/s^2}\n"},
        {GOOD_BODIES "lesson: Coasting\n", "a.yaml:5:9: error: `lesson` must be a mapping of keys and values: write "
                                           "lesson: {title: what there is to see}\n"},
        {"kind: sweep\nbase: a.yaml\n", "a.yaml:1:7: error: this is a sweep over many cases: `trundle sweep` runs it; "
                                        "a case has `kind`: biaxial | bodies | contact | patch\n"},
    };
    assert_messages(rows, sizeof rows / sizeof *rows);
}

/* Along a path the columns of contact.csv are measured. */
static void path_check_messages(void **state) {
    (void)state;
#define PATCH "kind: patch\nbodies: {R1: 10 mm, R2: 10 mm, E: 70 GPa, nu: 0.3}\nmu: 0.3\npath: [{force: 1 kN/m}]\n"
    static const begin_case rows[] = {
        {ROLL "checks: [{what: speed, exact: 1, tolerance: 1}]\n",
         "a.yaml:5:17: error: `speed` is not a choice for `what`; allowed is u_slide | u_roll | P | Q | q | a | "
         "moment_1 | moment_2 | f_r | overlap\n"},
        {ROLL "checks: [{what: p_max, exact: 1, tolerance: 1}]\n", "a.yaml:5:17: error: `p_max` is not a choice for "},
        {PATCH "checks: [{what: sticks, exact: 1, tolerance: 1}]\n",
         "a.yaml:5:17: error: `sticks` is not a choice for `what` (did you mean `stick`?); allowed is u_slide | u_roll "
         "| P | Q | q | a | moment_1 | moment_2 | f_r | overlap | p_max | stick | creepage | dissipated\n"},
        {GOOD_BODIES "checks: [{what: Q, exact: 1, tolerance: 1}]\n",
         "a.yaml:5:17: error: `Q` is not a choice for `what`; allowed is sliding-velocity | "},
        {ROLL "checks: [{segment: 0, exact: 1, tolerance: 1}]\n", "a.yaml:5:10: error: `checks.0.what` is missing: "},
        {ROLL "checks: [{what: Q, exact: 1 N, tolerance: 1}]\n", "a.yaml:5:27: error: wrong dimension"},
        {ROLL "checks: [{what: Q, exact: 1}]\n", "a.yaml:5:10: error: `checks.0.tolerance` is missing: "},
        {ROLL "checks: [{what: Q, law: 1, exact: 1, tolerance: 1}]\n",
         "a.yaml:5:25: error: there is no `laws.1`: laws count from 0 to 0\n"},
        {ROLL "checks: [{what: Q, segment: 1, exact: 1, tolerance: 1}]\n",
         "a.yaml:5:29: error: there is no `path.1`: segments count from 0 to 0, and -1 is the last\n"},
        {ROLL "checks: [{what: Q, segment: -2, exact: 1, tolerance: 1}]\n",
         "a.yaml:5:29: error: `segment` is -2, allowed is -1 to 1e+09\n"},
        {ROLL "checks: [{what: Q, at: 1 s, exact: 1, tolerance: 1}]\n",
         "a.yaml:5:20: error: `checks.0.at` is not for `kind: contact`; allowed here: what, law, segment, exact, "},
        {PATCH "checks: [{what: Q, law: 0, exact: 1, tolerance: 1}]\n",
         "a.yaml:5:20: error: `checks.0.law` is not for `kind: patch`; allowed here: what, segment, exact, "
         "tolerance\n"},
        {GOOD_BODIES "checks: [{what: speed, segment: 0, exact: 1, tolerance: 1}]\n",
         "a.yaml:5:24: error: `checks.0.segment` is not for `kind: bodies`; allowed here: what, disk, at, over, "},
    };
    assert_messages(rows, sizeof rows / sizeof *rows);
}

static void bodies_messages(void **state) {
    (void)state;
    static const begin_case rows[] = {
        {GOOD_BODIES "checks: [{exact: 1, tolerance: 1}]\n",
         "a.yaml:5:10: error: `checks.0.what` is missing: the measured quantity\n"},
        {GOOD_BODIES "checks: [{what: sped, exact: 1, tolerance: 1}]\n",
         "a.yaml:5:17: error: `sped` is not a choice for `what` (did you mean `speed`?); allowed is sliding-velocity | "
         "rolling-velocity | "},
        {GOOD_BODIES "checks: [{what: speed, exact: 1}]\n",
         "a.yaml:5:10: error: `checks.0.tolerance` is missing: largest |measured - exact| [m/s]\n"},
        {GOOD_BODIES "checks: [{what: speed, tolerance: 1}]\n",
         "a.yaml:5:10: error: `checks.0.exact` is missing: the closed form [m/s]\n"},
        {GOOD_BODIES "checks: [{what: speed, exact: 1, tolerance: 0}]\n",
         "a.yaml:5:45: error: `tolerance` is 0, allowed is 1e-30 to 1e+30 m/s\n"},
        {GOOD_BODIES "checks: [{what: speed, exact: 1, tolerance: -0.1*exact}]\n",
         "a.yaml:5:45: error: `tolerance` is -0.1, allowed is "},
        {GOOD_BODIES "checks: [{what: speed, exact: 1 rad/s, tolerance: 1}]\n",
         "a.yaml:5:31: error: wrong dimension: this is in s^-1 (`exact` is in m/s)\n"},
        {GOOD_BODIES "checks: [{what: speed, exact: tolerance, tolerance: exact}]\n",
         "a.yaml:5:53: error: these keys refer to each other in a circle: "},
        {GOOD_BODIES "checks: [{what: speed, contact: wall0-0, exact: 1, tolerance: 1}]\n",
         "a.yaml:5:24: error: `checks.0.contact` is not for `what: speed`; allowed here: what, disk, at, over, exact, "
         "tolerance\n"},
        {GOOD_BODIES "checks: [{what: creepage, contact: 0-1, disk: 0, exact: 1, tolerance: 1}]\n",
         "a.yaml:5:41: error: `checks.0.disk` is not for `what: creepage`; allowed here: what, contact, at, over, "
         "exact, tolerance\n"},
        {GOOD_BODIES "checks: [{what: stop-time, at: 1 s, exact: 1, tolerance: 1}]\n",
         "a.yaml:5:28: error: `checks.0.at` is not for `what: stop-time`; allowed here: what, disk, exact, "
         "tolerance\n"},
        {GOOD_BODIES "checks: [{what: slip-ends, contact: 0-1, over: 1 s, exact: 1, tolerance: 1}]\n",
         "a.yaml:5:42: error: `checks.0.over` is not for `what: slip-ends`; allowed here: what, contact, exact, "
         "tolerance\n"},
        {GOOD_BODIES "checks: [{what: creepage, exact: 1, tolerance: 1}]\n",
         "a.yaml:5:10: error: `checks.0.contact` is missing: the contact"},
        {GOOD_BODIES "checks: [{what: creepage, contact: [], exact: 1, tolerance: 1}]\n",
         "a.yaml:5:10: error: `checks.0.contact` is missing: the contact"},
        {GOOD_BODIES "checks: [{what: creepage, contact: [wall0-0, wall1-0], exact: 1, tolerance: 1}]\n",
         "a.yaml:5:46: error: more than 1 contact in `contact`\n"},
        {GOOD_BODIES "checks: [{what: creepage, contact: most-mobilised, exact: 1, tolerance: 1}]\n",
         "a.yaml:5:36: error: a check is of one contact, named as 0-1 (two disks) or wall0-1"},
        {GOOD_BODIES "checks: [{what: creepage, contact: 0-1, exact: 1, tolerance: 1}]\n",
         "a.yaml:5:36: error: there is no contact `0-1`: disks count from 0 to 0, walls are 0\n"},
        {GOOD_BODIES "checks: [{what: creepage, contact: 3 mm, exact: 1, tolerance: 1}]\n",
         "a.yaml:5:36: error: `3 mm` is no contact; name it "},
        {GOOD_BODIES "checks: [{what: rolls-from, exact: 10 deg, tolerance: 1 deg}]\n",
         "a.yaml:5:17: error: a slope to stand on takes a wall, which is not there\n"},
        {GOOD_BODIES "walls: [{nx: 0, ny: 1}]\nchecks: [{what: slips-from, exact: 10 deg, tolerance: 1 deg}]\n",
         "a.yaml:6:17: error: a slope to stand on takes gravity, which is not there\n"},
        {GOOD_BODIES
         "gravity: {y: -1}\nwalls: [{nx: 0, ny: 1}]\nchecks: [{what: slips-from, exact: 2, tolerance: 1}]\n",
         "a.yaml:7:36: error: a slope is looked for from 0 to 85 degrees, and `exact` is 2 rad\n"},
        {GOOD_BODIES "checks: [{what: spin, disk: 1, exact: 1, tolerance: 1}]\n",
         "a.yaml:5:29: error: there is no disk 1: disks count from 0 to 0\n"},
        {GOOD_BODIES "checks: [{what: spin, disk: -1, exact: 1, tolerance: 1}]\n",
         "a.yaml:5:29: error: `disk` is -1, allowed is 0 to 1000\n"},
        {GOOD_BODIES "checks: [{what: spin, at: 1.5 s, exact: 1, tolerance: 1}]\n",
         "a.yaml:5:27: error: `at` is 1.5 s, after `time_end`, which is 1 s\n"},
        {GOOD_BODIES "checks: [{what: spin, at: 0.5, over: 0.6, exact: 1, tolerance: 1}]\n",
         "a.yaml:5:38: error: `over` is 0.6 s, longer than the time up to `at`, 0.5 s\n"},
        {GOOD_BODIES "checks: [{what: spin, exact: 1, tolerence: 1}]\n",
         "a.yaml:5:33: error: unknown key `checks.0.tolerence` (did you mean `tolerance`?); allowed here: what, disk, "
         "at, over, exact, tolerance\n"},
        {GOOD_BODIES "checks: {what: spin}\n", "a.yaml:5:9: error: `checks` must be a list"},
        {GOOD_BODIES "---\nkind: biaxial\n",
         "a.yaml:6:1: error: `kind` must be the same in every document, and here it is "
         "not as in the first\nkind: biaxial\n^"},
        {GOOD_BODIES "---\nkind: [bodies]\n", "a.yaml:6:1: error: `kind` must be the same in every document"},
        {GOOD_BODIES "---\nlabel: b\ntime_end: 2 s\n", "a.yaml:7:1: error: `time_end` must be the same in every "},
        {GOOD_BODIES "---\noutput: {rows: 9}\n", "a.yaml:6:1: error: `output` must be the same in every document"},
        {GOOD_BODIES "output: {frames: 3}\n---\noutput:\n", "a.yaml:7:1: error: `output` must be the same in every "},
        {GOOD_BODIES "output: {contact: 0-1}\n",
         "a.yaml:5:19: error: there is no contact `0-1`: disks count from 0 to 0, walls are 0\n"},
        {GOOD_BODIES "output: {contact: wall0-0}\n", "a.yaml:5:19: error: there is no contact `wall0-0`: disks count "},
        {GOOD_BODIES "output: {contact: most-mobilised}\n",
         "a.yaml:5:19: error: the panel shows one contact, named as 0-1 (two disks) or wall0-1 (wall 0, disk 1)\n"},
        {GOOD_BODIES "output: {contact: [0-1, 0-2]}\n", "a.yaml:5:25: error: more than 1 contact in `contact`\n"},
        {GOOD_BODIES "output: {contact: first}\n", "a.yaml:5:19: error: `first` is no contact; name it 17-42 "},
        {GOOD "output: {contact: 0-1}\n", "a.yaml:5:10: error: `output.contact` is not for `kind: biaxial`; allowed "},
        {GOOD_BODIES "output: {paths: 0-1}\n---\nlabel: b\n", "a.yaml:5:17: error: there is no contact `0-1`"},
        {GOOD_BODIES "---\nlesson: {title: b}\n", "a.yaml:6:1: error: `lesson` must be the same in every document"},
        {GOOD_BODIES "---\n",
         "a.yaml:5:1: error: a further document must be a mapping: the keys that it changes\n---\n^"},
        {GOOD_BODIES "---\nlabel: b\n---\n- label: c\n", "a.yaml:7:1: error: a further document must be a mapping"},
        {GOOD_BODIES "---\nlabel: b\n---\nwords\n", "a.yaml:7:1: error: a further document must be a mapping"},
        {GOOD_BODIES "---\ncontact: {mew: 1}\n", "a.yaml:6:11: error: unknown key `contact.mew`"},
        {GOOD_BODIES "---\ncontact: {mu: 1, mu: 1}\n",
         "a.yaml:6:18: error: duplicate key `mu`; it is already given in line 6"},
        {GOOD_BODIES "---\ncontact: {mu: 1 m}\n", "a.yaml:6:15: error: wrong dimension"},
        {GOOD_BODIES "walls: [{nx: 0, ny: 1}]\nchecks: [{what: creepage, contact: wall0-0, exact: 1, tolerance: 1}]\n"
                     "---\nlabel: b\n---\nwalls:\n", /* what is wrong there was said in the first */
         "a.yaml:6:36: error: there is no contact `wall0-0`: disks count from 0 to 0, walls are 0\n"},
        {GOOD_BODIES "checks: [{what: speed, exact: 1 m/s*contact.mu, tolerance: exact}]\n---\ncontact: {mu: 0}\n",
         "a.yaml:5:60: error: `tolerance` is 0, allowed is "},
        {GOOD_BODIES "---\ndisks: [{radius: 1, x: 0}]\n", "a.yaml:6:9: error: `disks.0.y` is missing: "},
        {GOOD_BODIES "---\ncontact: 3\n", "a.yaml:6:10: error: `contact` must be a mapping"},
        {GOOD_BODIES "---\nlabel: 1\n---\nlabel: 2\n---\nlabel: 3\n---\nlabel: 4\n---\nlabel: 5\n---\nlabel: 6\n",
         "a.yaml:5:1: error: there are 7 documents (---), allowed is 1 to 6\n"},
        {ROLL "---\nlabel: b\n", "a.yaml:5:1: error: a second document (---) is not allowed\n---\n^"},
        {"---\n---\n", "a.yaml:2:1: error: `kind` is missing: "},
        {GOOD "checks: []\n", "a.yaml:5:1: error: `checks` is not for `kind: biaxial`; allowed here: "},
        {GOOD_BODIES "output: {still: 2*time_end}\n",
         "a.yaml:5:17: error: `still` is 2 s, after `time_end`, which is 1 s\n"},
        {NO_DISKS "disks: [{radius: 1, x: 0, y: 0, torque: 1 N, motion: driven}]\n",
         "a.yaml:4:41: error: a torque does nothing to `disks.0`, whose motion keeps its spin: take free or pinned\n"},
        {NO_DISKS "disks: [{radius: 1, x: 0, y: 0, torque: 1 N, motion: prescribed}]\n",
         "a.yaml:4:41: error: a torque does nothing"},
        {NO_DISKS "disks: [{radius: 1, x: 0, y: 0, torque: 1 N, motion: orbit}]\n",
         "a.yaml:4:41: error: a torque does nothing"},
    };
    assert_messages(rows, sizeof rows / sizeof *rows);
}

static void patch_messages(void **state) {
    (void)state;
#define IN "kind: patch\nbodies: {R1: 10 mm, R2: 10 mm, E: 70 GPa, nu: 0.3}\n"
    static const begin_case rows[] = {
        {IN "path: [{force: 1}]\n", "a.yaml:1:1: error: `mu` is missing: friction coefficient [1]\n"},
        {IN "mu: 0\npath: [{force: 1}]\n", "a.yaml:3:5: error: `mu` is 0, allowed is 1e-09 to 100\n"},
        {IN "mu: 0.3\nelements: 2\npath: [{force: 1}]\n",
         "a.yaml:4:11: error: `elements` is 2, allowed is 3 to 4000\n"},
        {IN "mu: 0.3\nsolver: exact\npath: [{force: 1}]\n", "a.yaml:4:9: error: `exact` is not a choice for `solver`"},
        {IN "mu: 0.3\npath: [{force: 0}]\n",
         "a.yaml:4:16: error: there is no contact to begin with: give a force above 0\n"},
        {IN "mu: 0.3\npath: [{force: -1}]\n", "a.yaml:4:16: error: `force` is -1, allowed is 0 to 1e+12 N/m\n"},
        {IN "mu: 0.3\npath: [{force: .nan}]\n", "a.yaml:4:16: error: expected "},
        {IN "mu: 0.3\npath: [{force: 1, tangential: 0.31*P}]\n",
         "a.yaml:4:31: error: the contact slides: `tangential` is 0.31 N/m, and mu times the force only 0.3 N/m\n"},
        {IN "mu: 0.3\npath: [{force: 1, tangential: -0.2}, {force: 0.5, tangential: -0.2}]\n",
         "a.yaml:4:63: error: the contact slides: "},
        {IN "mu: 0.3\npath: [{force: 1, tangential: 0.1, slide: 1 um}]\n",
         "a.yaml:4:43: error: `slide` and `tangential` mean the same: give one of them\n"},
        {IN "mu: 0.3\npath: [{force: 1, overlap: 1 um}]\n",
         "a.yaml:4:19: error: `path.0.overlap` is not for `kind: patch`"},
        {IN "mu: 0.3\nsolver: carter\npath: [{force: 1, slide: 1 um, roll: 1 um}, {force: 1, slide: 1 um}]\n",
         "a.yaml:5:45: error: `solver: carter` is for steady rolling: `path.1` does not roll\n"},
        {IN "mu: 0.3\nsolver: cattaneo\npath: [{force: 1, slide: 1 um}, {force: 1, slide: -1 um}]\n",
         "a.yaml:5:33: error: `solver: cattaneo` is for sliding one way from rest"},
        {IN "mu: 0.3\nsolver: cattaneo\npath: [{force: 1, slide: 1 um, roll: 1 um}]\n",
         "a.yaml:5:8: error: `solver: cattaneo` is for sliding one way from rest"},
        {IN "mu: 0.3\ndepth: 99 um\npath: [{force: 60 kN/m}]\n",
         "a.yaml:5:16: error: this presses the contact as wide as its depth, 9.9e-05 m; give a smaller force or a "
         "larger "
         "`depth` or `Lambda`\n"},
        {IN "mu: 0.3\ndepth: 1\nLambda: 2\npath: [{force: 1}]\n",
         "a.yaml:4:8: error: `depth` and `Lambda` mean the same: give one of them\n"},
        {IN "mu: 0.3\nlaws: [{}]\npath: [{force: 1}]\n",
         "a.yaml:4:1: error: `laws` is not for `kind: patch`; allowed here: "},
        {"kind: patch\nbodies: {R1: 1, R2: 1, E: 0, nu: 0}\nmu: 0.3\npath: [{force: 1}]\n",
         "a.yaml:2:27: error: `E` is 0, allowed is 0.001 to 1e+15 Pa\n"},
    };
    assert_messages(rows, sizeof rows / sizeof *rows);
}

static void contact_messages(void **state) {
    (void)state;
    static const begin_case rows[] = {
        {PAIR LAWS, "a.yaml:3:48: error: `path` has 0 items, allowed is 1 to 1000\n"},
        {PAIR LAWS "path: []\n", "a.yaml:4:7: error: `path` has 0 items, allowed is 1 to 1000\n"},
        {PAIR "laws: []\npath: [{force: 1}]\n", "a.yaml:3:7: error: `laws` has 0 items, allowed is 1 to 32\n"},
        {PAIR LAWS "path: [{slide: 1 um}]\n", "a.yaml:4:8: error: `path.0.force` is missing: normal force at the end"},
        {PAIR LAWS "path: [{force: -1 kN/m}]\n",
         "a.yaml:4:16: error: `force` is -1000, allowed is 0 to 1e+12 N/m\npath: [{force: -1 kN/m}]\n               ^"},
        {PAIR LAWS "path: [{force: 1 kN}]\n", "a.yaml:4:16: error: wrong dimension: this is in kg m s^-2 (`force`"},
        {PAIR LAWS "path: [{force: 1, steps: 0}]\n", "a.yaml:4:26: error: `steps` is 0, allowed is 1 to 1e+06\n"},
        {PAIR LAWS "path: [{force: 1, slide: .nan}]\n", "a.yaml:4:26: error: expected "},
        {PAIR LAWS "path: [{force: 0, roll: 3*a}]\n",
         "a.yaml:4:25: error: `a` stands for `sqrt(4*P*R_star/(pi*E_star))` here, and that fails: `a` is 0, allowed "},
        {PAIR LAWS "path: [{force: 1, a: 3 mm}]\n",
         "a.yaml:4:19: error: `path.0.a` follows from other keys, sqrt(4*P*R_star/(pi*E_star)), and cannot be given\n"},
        {PAIR LAWS "path: [{force: previous.force}]\n",
         "a.yaml:4:16: error: these keys refer to each other in a circle: "},
        {PAIR LAWS "path: [{force: 1, slip: 2}]\n",
         "a.yaml:4:19: error: unknown key `path.0.slip` (did you mean "
         "`slide`?); allowed here: force, slide, roll, steps, overlap, time\n"},
        {ROLL "E_star: 3 GPa\n", "a.yaml:5:1: error: `E_star` follows from other keys, bodies.E/(2*(1 - "
                                 "bodies.nu^2)), and cannot be given\n"},
        {ROLL "seed: 3\n", "a.yaml:5:1: error: `seed` is not for `kind: contact`; allowed here: kind, language, "
                           "lesson, output, bodies, laws, "
                           "path, checks\n"},
        {ROLL "contact: {mu: 1}\n", "a.yaml:5:1: error: `contact` is not for `kind: contact`; allowed here: "},
        {PAIR "laws: [{friction: coulomb-spring}]\npath: [{force: 1}]\n",
         "a.yaml:3:8: error: `laws.0.k_t` is not given, and its default `0.5*k_n` fails: `k_n` belongs to the law "
         "linear, which "
         "is not chosen (`k_t` is in Pa); give `k_t`\n"},
        {PAIR "laws: [{friction: coulomb, k_t: 1}]\npath: [{force: 1}]\n",
         "a.yaml:3:19: error: `coulomb` is not a choice for `friction`"},
        {PAIR "laws: [{normal: linear}]\npath: [{force: 1}]\n",
         "a.yaml:3:8: error: `laws.0.k_n` is missing: stiffness k_n [Pa]\n"},
        {PAIR "laws: {friction: none}\npath: [{force: 1}]\n", "a.yaml:3:7: error: `laws` must be a list"},
        {"kind: contact\nbodies: {R1: 0, R2: 1, E: 1, nu: 0}\n" LAWS "path: [{force: 1}]\n",
         "a.yaml:2:14: error: `R1` is 0, allowed is 1e-09 to 1000 m\n"},
        {"kind: contact\nbodies: {R1: 1, R2: 1, E: -1 Pa, nu: 0}\n" LAWS "path: [{force: 1}]\n",
         "a.yaml:2:27: error: `E` is -1, allowed is 0.001 to 1e+15 Pa\n"},
        {"kind: contact\nbodies: {R1: 1, R2: 1, E: 1, nu: 0.51}\n" LAWS "path: [{force: 1}]\n",
         "a.yaml:2:34: error: `nu` is 0.51, allowed is -0.999 to 0.5\n"},
        {"kind: contact\nbodies: {R1: 1, R2: 1, E: 1, nu: 0, shape: cube}\n" LAWS "path: [{force: 1}]\n",
         "a.yaml:2:44: error: `cube` is not a choice for `shape`; allowed is disk | sphere\n"},
        {BALLS "laws: [{}]\npath: [{force: 1 N/m}]\n",
         "a.yaml:4:16: error: wrong dimension: this is in kg s^-2 (`force` is in N)\n"},
        {BALLS "laws: [{normal: linear, k_n: 1 Pa}]\npath: [{force: 1}]\n",
         "a.yaml:3:30: error: wrong dimension: this is in kg m^-1 s^-2 (`k_n` is in N/m)\n"},
        {BALLS "laws: [{normal: hertz-line}]\npath: [{force: 1}]\n",
         "a.yaml:3:17: error: the law hertz-line is for disks, and `shape` is sphere\n"},
        {PAIR "laws: [{normal: hertz-sphere}]\npath: [{force: 1}]\n",
         "a.yaml:3:17: error: the law hertz-sphere is for spheres, and `shape` is disk\n"},
        {PAIR LAWS "path: [{force: 1, overlap: 1 um}]\n",
         "a.yaml:4:16: error: `force` and `overlap` mean the same: give one"},
        {PAIR LAWS "path: [{overlap: 1 um, slide: P}]\n",
         "a.yaml:4:31: error: `P` stands for `previous.force` here, and that fails: `path.0.force` is not known: "
         "`overlap` is given in its place"},
        {"kind: contact\nbodies: {R1: 1, R2: 1, E: 1, nu: 0, depth: 1, Lambda: 2}\n" LAWS "path: [{force: 1}]\n",
         "a.yaml:2:55: error: `Lambda` and `depth` mean the same: give one"},
        {"kind: contact\nbodies: {R1: 10 mm, R2: 10 mm, E: 70 GPa, nu: 0.3, depth: 99 um}\n" LAWS
         "path: [{force: 1 kN/m}, {force: 60 kN/m}]\n",
         "a.yaml:4:33: error: this presses the contact of `laws.0` as wide as its depth, 9.9e-05 m; give a smaller "
         "force "
         "or a larger `bodies.depth` or `bodies.Lambda`\n"},
        {"kind: contact\nbodies: {R1: 10 mm, R2: 10 mm, E: 70 GPa, nu: 0.3, depth: 10 um}\n" LAWS
         "path: [{overlap: 0.012 um}]\n",
         "a.yaml:4:18: error: this presses the contact of `laws.0` as wide as its depth, 1e-05 m; give a smaller "
         "overlap"},
        {"kind: contact\nbodies: {R1: 10 mm, R2: 10 mm, E: 70 GPa, nu: 0.3, Lambda: 3}\n" LAWS
         "path: [{overlap: 1 um}]\n",
         "a.yaml:2:60: error: `Lambda` is ln(2d/a) at the force of the first segment, which gives none: give "
         "`depth`\n"},
        {PAIR "laws: [{rolling: wang-spring, k_r: 1}]\npath: [{force: 1, time: 1}]\n",
         "a.yaml:2:9: error: `bodies.density` is missing: rolling law wang-spring of `laws.0` depends on the inertia"},
        {"kind: contact\nbodies: {R1: 1, R2: 1, E: 1, nu: 0, density: 1}\n"
         "laws: [{rolling: wang-spring, k_r: 1}]\npath: [{force: 1e-3, time: 1}, {force: 1e-3}]\n",
         "a.yaml:4:32: error: `path.1.time` is missing: rolling law wang-spring of `laws.0` depends on the rate\n"},
        {"kind: biaxial\ncontact: {normal: hertz-line, E_star: 1 GPa, step: exact, k_t: 1}\n"
         "sample: {r_min: 1, r_max: 1}\ncompaction: {pressure: 1}\n",
         "a.yaml:2:52: error: `step: exact` of the law hertz-line is for `kind: contact` only\n"},
        {"kind: contact\nbodies: {R1: 1, R2: 1, nu: 0}\n" LAWS "path: [{force: 1}]\n",
         "a.yaml:2:9: error: `bodies.E` is missing: Young's modulus of both bodies [Pa]\n"},
    };
    assert_messages(rows, sizeof rows / sizeof *rows);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(messages),        cmocka_unit_test(contact_messages),    cmocka_unit_test(patch_messages),
        cmocka_unit_test(bodies_messages), cmocka_unit_test(path_check_messages), cmocka_unit_test(habits_messages),
        cmocka_unit_test(limits),          cmocka_unit_test(too_many_disks),      cmocka_unit_test(long_lines)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
