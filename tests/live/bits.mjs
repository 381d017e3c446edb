// SPDX-License-Identifier: MIT
// What native.c does, in WebAssembly. usage: node bits.mjs ENGINE.mjs LIVE.wasm STEPS CASE.yaml...
//    or: node bits.mjs ENGINE.mjs LIVE.wasm card CARD.csv
//    or: node bits.mjs ENGINE.mjs LIVE.wasm cycle R1,R2,overlap,du,dtheta,STEPS,LAWS...
//    or: node bits.mjs ENGINE.mjs LIVE.wasm patch CASE.yaml PATCH.csv
import {readFileSync} from 'node:fs';
const [enginePath, wasm, what, ...files] = process.argv.slice(2);
const {loadEngine} = await import(enginePath);
const engine = await loadEngine(readFileSync(wasm));

// The card as `trundle measures -o` writes it: each motion again, each definition again, with 17 digits. The columns of
// the definitions stand in the order of the tables, those of rolling first.
function card(file) {
    const [head, ...rows] = readFileSync(file, 'utf8').trim().split('\n').map(line => line.split(','));
    const first = head.indexOf('Vr_wang');
    let same = 0;
    for (const row of rows) {
        const of = Object.fromEntries(head.map((name, k) => [name, Number(row[k].replace('inf', 'Infinity'))]));
        const got = engine.measure({
            R1: of.R1,
            R2: of.R2,
            x1: of.x1x,
            y1: of.x1y,
            vx1: of.v1x,
            vy1: of.v1y,
            w1: of.w1,
            x2: of.x2x,
            y2: of.x2y,
            vx2: of.v2x,
            vy2: of.v2y,
            w2: of.w2
        });
        [...Object.values(got.rolling), ...Object.values(got.sliding)].forEach((value, k) => {
            const native = of[head[first + k]];
            if (Object.is(value + 0, native))
                same++;
            else
                console.log(`${row[0]}: ${head[first + k]} is ${value}, native ${native}`);
        });
    }
    console.log(`${same} values of ${rows.length} motions are the same`);
}

// The last instant of patch.csv: x, p, tau, slip of each element.
function patch(path, csv) {
    const rows = readFileSync(csv, 'utf8').trim().split('\n').map(line => line.split(',')), head = rows.shift();
    const columns = ['x_m', 'p_Pa', 'tau_Pa', 'slip_m', 'stick'].map(name => head.indexOf(name)),
          step = Number(rows[rows.length - 1][1]), last = rows.filter(row => Number(row[1]) === step);
    const inside = engine.inside(readFileSync(path, 'utf8'));
    inside.step(step);
    const all = inside.elements();
    const same = last.filter((row, i) => [all[i].x, all[i].p, all[i].tau, all[i].slip, Number(all[i].side === 0)].every(
                                 (value, k) => value === Number(row[columns[k]])));
    console.log(`${same.length} of ${all.length} elements are the same`);
}

// All bits of a number.
function bits(x) {
    return new DataView(new Float64Array([x]).buffer).getBigUint64(0, true).toString(16);
}

if (what === 'card')
    card(files[0]);
else if (what === 'patch')
    patch(...files);
else if (what === 'cycle')
    for (const text of files) {
        const [R1, R2, overlap, du, dtheta, steps, ...laws] = text.split(',');
        const of = {R1: Number(R1), R2: Number(R2), overlap: Number(overlap), du: Number(du), dtheta: Number(dtheta)};
        try {
            const cycle = engine.cycle(laws.join(','), of);
            cycle.step(Number(steps));
            console.log(bits(cycle.state().work));
        } catch (e) {
            console.log(e.message);
        }
    }
else
    for (const file of files) {
        try {
            const world = engine.open(0, readFileSync(file, 'utf8'));
            world.step(Number(what));
            console.log(`${file} ${world.hash()}`);
        } catch (e) {
            console.log(e.message.replace('case.yaml', file));
        }
    }
