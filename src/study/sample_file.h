/* SPDX-License-Identifier: MIT */
/* sample.file: somebody else's packing, to begin with. */
#ifndef TR_STUDY_SAMPLE_FILE_H
#define TR_STUDY_SAMPLE_FILE_H

#include "scene/scene.h"

/* Reads the packing of a scene that names one into scene->sample: place, disks, width, height, file_hash; else nothing.
 * CSV with the columns x, y, r [m], or a text dump of LAMMPS with x, y, radius, of which the last instant counts.
 * Places are moved so that the box begins at 0. TR_BAD_CASE with "file:line: error: ...": also where two disks, or a
 * disk and a wall, overlap by more than 0.3 of the smaller radius, or where a disk is outside of its box; TR_FILE. */
bool tr_sample_file_read(tr_scene *scene, tr_status *st);

#endif
