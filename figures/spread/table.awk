# SPDX-License-Identifier: MIT
# step.csv and rows.csv as the rows of src/study/spread.c.
FNR == 1 { file++; next }
file == 1 { printf "step %s: {%s, %s, %s}\n", $1, $2, $3, $4; next }
{ printf "    {%s, %s, \"%s\", %s, %s, {%s, %s}},\n", $1, $2, $3, $4, $5, $6, $7 }
