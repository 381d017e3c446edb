# SPDX-License-Identifier: MIT
# What the pictures share. `names`: definitions, separated by blanks. Where curves coincide, each is narrower than the
# one below it.
set datafile separator ','
set datafile missing NaN # rows of other curves do not break a line
set grid linecolor '#d0d0d0'
array color[4] = ['#7f4a90', '#00714f', '#7fbf9f', '#a89a00']
array width[4] = [10, 6.5, 4, 2]
array mark[4] = [7, 5, 9, 11]
colour(i) = color[(i - 1)%4 + 1]
