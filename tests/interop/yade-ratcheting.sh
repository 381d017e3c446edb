#!/bin/sh
# SPDX-License-Identifier: MIT
# The card in YADE without avoidGranularRatcheting.
RATCHETING=yes exec "$(dirname "$(realpath "$0")")/yade.sh" "$@"
