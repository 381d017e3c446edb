#!/bin/sh
# SPDX-License-Identifier: MIT
# The films of two runs of a biaxial test side by side, as NAME.mp4, and their last frames as NAME.png. Without ffmpeg: nothing.
# usage: figures/beside/beside.sh LEFT RIGHT NAME
set -eu
command -v ffmpeg >/dev/null || { echo "no $3.mp4: ffmpeg is not installed"; exit; }
last() { find "$1/frames" -name '*.png' | sort | tail -n 1; }
both='[0]scale=960:-2[l];[1]scale=960:-2[r];[l][r]hstack'
ffmpeg -v error -y -i "$1/biaxial.mp4" -i "$2/biaxial.mp4" -filter_complex "$both" -c:v libx264 -preset veryfast -pix_fmt yuv420p -f mp4 "$3.mp4.part"
mv "$3.mp4.part" "$3.mp4"
ffmpeg -v error -y -i "$(last "$1")" -i "$(last "$2")" -filter_complex "$both" -f image2 -c:v png "$3.png.part"
mv "$3.png.part" "$3.png"
