#!/bin/sh
# SPDX-License-Identifier: MIT
# The page of the comparison, from the tables in DIR. It is XML too.
# usage: page.sh DIR VERSION
set -eu
out=$1 version=$2
here=$(cd "$(dirname "$0")" && pwd)
# shellcheck source=figures/gallery/tables.sh
. "$here/../gallery/tables.sh"

seeds=$(awk -F, 'NR == 2 {print $4}' "$out/effects.csv")
# verdicts OF: the rows of effects.csv on one kind of rolling resistance
verdicts() {
    awk -F, -v of="$1" 'BEGIN { OFS = ","; print "number", "beside", "verdict", "change ± 95 %", "± for all verdicts", "too little to matter" }
        function signed(v) { return (v > 0 ? "+" : "") v }
        $2 == of { change = signed($5); sub(/-/, "−", change); print $1, $3, $9, change " ± " $6, "± " $7, "± " $8 }' "$out/effects.csv" >"$out/table.csv"
    table table.csv "$2"
    rm "$out/table.csv"
}
# The verdicts of one kind beside the other in a row each
summary() {
    awk -F, 'BEGIN { print "kind,peak sin φ,residual sin φ,dilatancy e − e0,rolling share" }
        function put(of) {
            printf "%s", of
            for (i = 1; i <= 4; i++) printf ",%s", a[of, name[i]] == b[of, name[i]] ? a[of, name[i]] : a[of, name[i]] " (μ_r = 0); " b[of, name[i]] " (0.5)"
            print ""
        }
        $9 != "" && NR > 1 {
            if (!($1 in known)) { known[$1] = 1; name[++n] = $1 }
            if (!(($2, $1) in a)) a[$2, $1] = $9; else b[$2, $1] = $9
        }
        END { put("contact moment"); put("creep") }' "$out/effects.csv" >"$out/table.csv"
    table table.csv 'What each kind of rolling resistance does'
    rm "$out/table.csv"
}
film() {
    if [ -s "$out/film/biaxial.mp4" ]; then
        echo '<video src="film/biaxial.mp4" controls="controls" loop="loop" muted="muted" playsinline="playsinline"></video>'
    else
        echo "<img class=\"picture\" src=\"film/frames/$(ls "$out/film/frames" | tail -n 1)\" alt=\"The last frame\"/>"
    fi
}
# fact KEY: of the run of the film
fact() { sed -n "s/.*\"$1\": \"*\([^\",]*\).*/\1/p" "$out/film/summary.json" | head -n 1; }

begin 'Two kinds of rolling resistance' 'section td:nth-child(4), section td:nth-child(5) { white-space: nowrap; }'
cat <<HTML
<header>
<h1>Two kinds of rolling resistance</h1>
<p>A contact can resist rolling in two ways [Kuhn2014]. A <b>contact moment</b> acts against rolling: here the rolling spring of Wang,
with μ_r. Second, friction <b>creeps</b> while a contact rolls: the material that carries the traction leaves the contact, and the friction force
fades. The model here is the friction of Dahlberg and Alfredsson with Carter's creepage. What does each do to $(fact n_disks) disks in the biaxial test?</p>
<p>Computed by $version: $seeds samples. All runs of a sample start from the same packing, and differences are taken sample by sample.</p>
<h2>The short answer</h2>
$(summary)
<p>“within 0.02”: the change is smaller than 0.02. “undecided”: $seeds samples cannot tell; it does not mean “no effect”. The last section says more.</p>
</header>
<main>
<section>
<h2>The film</h2>
$(film)
<p>One sample with both. The bar across each contact is its width, much exaggerated. Dark: it sticks. Orange: it slips. The law itself does not know
where a contact slips. The picture shows steady rolling with the same friction force [Carter1926], the state to which the law tends. The walls have no
friction, so contacts with a wall are orange. The panel shows one contact from
the inside. That is the exact elastic contact, driven along the path that the contact took in the run. “law” is the friction of the run, “exact” that of the
exact contact, both over μP. The sign tells the direction.</p>
</section>
<section>
<h2>The curves</h2>
$(picture curves.png 'Stress ratio and void ratio against strain for six combinations, with intervals')
<p>Means over $seeds samples. The band is the 95 % interval of the mean (Student).</p>
</section>
<section>
<h2>1. The contact moment</h2>
<p>Runs with μ_r = 0.5 less runs with μ_r = 0.</p>
$(verdicts 'contact moment' 'What the contact moment changes')
</section>
<section>
<h2>2. Creep</h2>
<p>Runs with creep less runs with the spring. Rolling in the creep is that of Wang, R1R2/(R1+R2) (ω1 − ω2).</p>
$(verdicts creep 'What creep changes')
$(picture effects.png 'Changes by creep with their intervals; the grey band is too little to matter')
<p>Kuhn calls another motion rolling: (s1 + s2)/2, the mean speed at which material runs through the contact. Creep with his rolling less creep with
that of Wang:</p>
$(verdicts "Kuhn's rolling less Wang's" "What Kuhn's rolling in the creep changes")
</section>
<section>
<h2>How to read the verdicts</h2>
<p>“raises” or “lowers”: the interval leaves out 0. “within”: the whole interval lies in the grey band; a change is too small to matter in a test with few samples.
“undecided”: the interval leaves out neither 0 nor a change that matters. That is <b>not</b> “no effect”. The wider interval decides (thin line in the picture): it is
such that all 24 verdicts hold together in 95 of 100 repetitions of the study (Bonferroni). The narrow one (thick line) is the 95 % interval of a single difference.
The rule was written before the runs: <code>figures/creep/effects.awk</code>.</p>
<p>All numbers hold for this case: <code>cases/biaxial-creep.yaml</code>, I = $(fact inertial_number), κ = k_n/pressure = $(fact stiffness_ratio | sed 's/\.0$//'), 20 % strain. The residual is the mean over 15 to 20 %
strain. The dilatancy is the void ratio there less that at the start. The rolling share is Σ|V_r| / Σ(|V_r| + |V_s|) there, by Wang.</p>
</section>
</main>
</body>
</html>
HTML
