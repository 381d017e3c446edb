# SPDX-License-Identifier: MIT
# What the pictures share: a colour, a mark and a name for each definition of the rolling velocity.
set datafile separator ','
set datafile missing NaN # rows of other curves do not break a line
set grid linecolor '#d0d0d0'
array model[4] = ['wang', 'bagi-kuhn', 'alonso-min', 'alonso-mean']
array name[4] = ['Wang, model 1', 'Bagi-Kuhn', 'Alonso, min (model 2)', 'Alonso, mean (model 2)']
array color[4] = ['#000000', '#7f4a90', '#00714f', '#a89a00']
array mark[4] = [7, 5, 9, 11]
# Rows of one model and quantity; `minus` empty: the quantity itself. Others are NaN. Marks of the models stand side by
# side.
pick(m, q, minus, column) = strcol('contact.rolling_velocity') eq model[m] && strcol('quantity') eq q && \
    strcol('minus') eq minus ? column : NaN
aside(m) = 0.016*(m - 2.5)
wang = 'contact.rolling_velocity=wang'
