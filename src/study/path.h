/* SPDX-License-Identifier: MIT */
/* The path of a contact from a CSV file, as `path: FILE.csv` names it. Columns: u_slide_m, u_roll_m, since the start of
 * the path, and the normal force P_N_per_m (spheres: P_N); time_s, since the start, if a law depends on the rate. Each
 * row is the end of a piece of the path, which is taken as straight. The path starts at u = 0, time 0, under the force
 * of the first row: so the contact.csv of a run is a path and gives the same run. One difference: a law that creeps
 * takes a row that rolls further than an element (a/100) in shorter steps. If there is a column `law`, only the rows
 * with the law of the first row count. */
#ifndef TR_STUDY_PATH_H
#define TR_STUDY_PATH_H

#include "scene/scene.h"

/* Fills scene->path with one segment for each row of scene->path_file. TR_BAD_CASE with "file:line: error: ...", also
 * if a law cannot follow the path; TR_FILE. */
bool tr_path_read(tr_scene *scene, tr_status *st);

#endif
