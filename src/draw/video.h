/* SPDX-License-Identifier: MIT */
/* A film of frames, by ffmpeg. */
#ifndef TR_DRAW_VIDEO_H
#define TR_DRAW_VIDEO_H

#include "draw/canvas.h"

/* A film: frames go through a pipe to ffmpeg, which must be on the PATH. */
typedef struct tr_video tr_video;

bool tr_video_available(void);

/* Starts ffmpeg writing path.part, H.264 in MP4. NULL and TR_FILE when it cannot start. */
tr_video *tr_video_open(const char *path, int frames_per_second, tr_status *st);

/* Appends what the canvas shows. If ffmpeg has died: TR_FILE and ffmpeg's message; tr_video_close must still be
 * called. */
bool tr_video_frame(tr_video *video, const tr_canvas *canvas, tr_status *st);

/* Ends the film and frees it. With all frames taken renames path.part to path; otherwise, or if keep is false, removes
 * it. False and TR_FILE when ffmpeg failed or no frame was sent. NULL is allowed and true. */
bool tr_video_close(tr_video *video, bool keep, tr_status *st);

enum { TR_GIF_RATE = 12 }; /* largest number of frames a second */

/* Writes the film as a GIF: 640 pixels wide, endless, every k-th frame. On failure TR_FILE and no file. */
bool tr_video_gif(const char *film, const char *path, int frames_per_second, tr_status *st);

#endif
