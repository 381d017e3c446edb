#!/bin/sh
# SPDX-License-Identifier: MIT
# The page of the comparison, from the tables in DIR. It is XML too.
# usage: page.sh DIR SEEDS VERSION NAMES
set -eu
out=$1 seeds=$2 version=$3 names=$4
here=$(cd "$(dirname "$0")" && pwd)

# shellcheck source=figures/gallery/tables.sh
. "$here/../gallery/tables.sh"
detectable() { awk -F, -v what="$1" '$1 == what && $6 != "" {print $6; exit}' "$out/strength.csv"; }

begin 'What is rolling? The definitions compared' 'td:nth-child(2) { white-space: nowrap; }
thead th { min-width: 6rem; white-space: normal; vertical-align: bottom; }'
cat <<HTML
<header>
<h1>What is rolling?</h1>
<p>Definitions of the rolling velocity of a contact: $(echo "$names" | sed 's/ /, /g'). Computed by $version.</p>
<p>With s1 and s2, the speeds at which the contact point runs over the two rims: <b>wang</b> is R1R2/(R1+R2) (ω1 − ω2); <b>bagi-kuhn</b> is
(s1 + s2)/2; <b>alonso-min</b> is the smaller and <b>alonso-mean</b> the mean of both where they have the same sign, and 0 elsewhere.</p>
<p>The short answer: they agree on pure rolling. They differ where disks slide (bagi-kuhn) and where one rim stands still or runs the other way
(alonso). Moments that do not fit the definition make energy. In an assembly of 400 disks, $seeds samples cannot show small differences of
strength.</p>
</header>
<main>
<section>
<h2>1. Motions</h2>
<p>Each definition sees no rolling in a rigid rotation and the speed of the rim in gears. Only bagi-kuhn sees rolling where disks of unequal
size slide without relative spin. The last column is the largest difference from the closed form over 21 ratios R2/R1 from 1/10 to 10; the numbers are written with ten digits.</p>
$(table kinematics.csv 'Rolling velocity, closed form and program')
$(picture motions.png 'Rolling velocity of two pure motions, and energy made in two closed cycles, against the ratio of the radii')
</section>
<section>
<h2>2. Energy of closed cycles</h2>
<p>A linear rolling spring, far below its bound, is taken through a cycle and ends unstretched. What it has done on the disks is made from nothing
(negative: lost to nowhere). The paper gives the moments ∓R_eff T to all definitions. Conjugate moments are the transpose of the velocity: for
V_r = A ω1 + B ω2 + C V_t they are −A T and −B T, with a force −C T along the contact. Energy is over k_r R_eff Δu Δθ1 in the first cycle and over
k_r R1 Δθ1 u in the second.</p>
$(table energy.csv 'Energy made in a closed cycle')
<p>So a definition and its source of energy are two things. The paper's moments fit only wang. In these two cycles conjugate moments make no
energy for any of them. The law conjugate-spring has these moments for any definition. The rows “with conjugate moments” use the T of
wang-spring and the moments above. For alonso, V_r is not the rate of a length: after other closed cycles its spring may stay stretched.</p>
</section>
<section>
<h2>3. One contact</h2>
<p>Disks of 5 and 10 mm, normal force 1 kN/m, bound of T 10 N/m. Each spring follows its own definition along one path: slide without relative spin,
roll like gears, spin disk 1 alone, roll back to the bound, slide and roll. “By hand” is the same spring, clamped, worked out from the path.
Where alonso sees no rolling, its conjugate moments are zero although its spring is stretched. So they jump. Where both rims run equally fast,
alonso-min could put the moment on either disk; here it is on disk 2.</p>
$(picture contact.png 'Force of the rolling spring and moments on disk 1 by each definition along the path')
$(table contact.csv 'At the end of each part of the path')
</section>
<section>
<h2>4. An assembly</h2>
<p>The biaxial test with each definition and the paper's moments: $seeds samples, the same packings for all definitions, so that differences
are taken sample by sample. Intervals are of 95 % (Student).</p>
$(picture strength.png 'Differences of peak, residual and void ratio from wang with intervals; the grey band is the detectable difference')
$(table strength.csv "Strength and void ratio of $seeds samples")
<p><b>What $seeds samples can say, and what not.</b> “differs”: the interval leaves out 0. “equal within”: the interval lies inside ± that number. Else
“undecided”, which is <b>not</b> “equal”: a difference may be there and be missed. The last column is the least true difference that $seeds samples would
call “differs” in 80 of 100 trials, if differences scatter as those of 32 other samples do: $(detectable 'peak sin φ') in the peak,
$(detectable 'residual sin φ') in the residual, $(detectable 'residual void ratio') in the void ratio. Smaller differences are mostly not seen (grey band of
the picture). Of nine such intervals one in twenty misses the truth, so a lone “differs” is weak: about four in ten pages show at least one where
none is, if all nine were independent. $(
    awk -F, '/energy made/ && $2 != "wang" && $3 + 0 > 0.01 {n++} END {
        if (n) print "The runs of " n " definitions make energy (above 1 % of the work of the walls), so their strength is not due to rolling resistance only."
    }' "$out/strength.csv")</p>
<p>More samples: <code>make wang</code> takes 32 and twelve values of μ_r, in 20 minutes.</p>
</section>
</main>
</body>
</html>
HTML
