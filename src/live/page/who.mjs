/* SPDX-License-Identifier: MIT */
/* Scene 5: the same motion by all definitions of rolling, for an observer who may turn. */
import {short} from './draw.mjs';
import {word} from './words.mjs';

const R1 = .2, SHOWN = ['wang', 'bagi-kuhn', 'alonso-min', 'alonso-mean'];

/* Two wheels with fixed centres, for an observer who turns. Their overlap is given in tenths of the smaller radius. */
function motion(s) {
    const R2 = R1 * 10 ** s.ratio, one = {x1: 0, y1: 0, vx1: 0, vy1: 0, w1: s.w1},
          L = R1 + R2 - .1 * s.overlap * Math.min(R1, R2);
    const m = {R1, R2, ...one, x2: L, y2: 0, vx2: 0, vy2: 0, w2: s.w2};
    return {...m, vy1: m.vy1 + s.turn * m.x1, vy2: m.vy2 + s.turn * m.x2, w1: m.w1 + s.turn, w2: m.w2 + s.turn};
}

export const whoScene = {
    id: 'who',
    seconds: 6,
    pace: 1,
    controls: [
        {key: 'ratio', name: 'log₁₀ R₂/R₁', unit: '', min: -1, max: 1, step: .01, value: .3},
        {key: 'w1', name: 'ω₁', unit: 'rad/s', min: -3, max: 3, step: .01, value: 1},
        {key: 'w2', name: 'ω₂', unit: 'rad/s', min: -3, max: 3, step: .01, value: .4},
        {key: 'overlap', name: 'overlap', unit: 'R/10', min: 0, max: 2, step: .01, value: 0},
        {key: 'turn', name: 'observer', unit: 'rad/s', min: -3, max: 3, step: .01, value: 0},
    ],
    text(s) {
        const m = motion(s);
        return `# ${word('scene.who.title')}\nkind: bodies\ntime_end: ${whoScene.seconds} s\n` +
               'contact: {k_n: 1 MPa, friction: none, rolling: none}\nstep: {dt: 1 ms}\ndisks:\n' +
               `  - {radius: ${m.R1} m, x: 0, y: 0, spin: ${m.w1} rad/s, motion: prescribed}\n` +
               `  - {radius: ${m.R2} m, x: ${m.x2} m - 1 um, y: 0, spin: ${m.w2} rad/s, motion: orbit, orbit: ${
                   s.turn} rad/s}\n` +
               'output: {frames: 100, rows: 101, contacts: 11}\n';
    },
    begin: () => ({}),
    draw(p, {world}, s, r) {
        const whole = p.box, a = world.disk(0), b = world.disk(1), reach = a.radius + 2 * b.radius,
              beta = s.turn * world.time();
        p.view(0, 0, reach, reach, {x: whole.x, y: whole.y, w: .5 * whole.w, h: whole.h});
        for (const d of [a, b]) {
            p.circle(d.x, d.y, d.radius, {fill: p.fill, stroke: p.ink});
            p.path([[d.x, d.y], [d.x + .9 * d.radius * Math.cos(d.angle), d.y + .9 * d.radius * Math.sin(d.angle)]],
                   p.ink, .2);
        }
        p.circle(a.radius * Math.cos(beta), a.radius * Math.sin(beta), .02 * reach, {fill: p.ink});
        const scale = [p.x0, p.y0, p.scale];
        if (r.tell) this.bars(p, {x: whole.x + .52 * whole.w, y: whole.y, w: .48 * whole.w, h: whole.h}, r);
        [p.x0, p.y0, p.scale] = scale, p.box = whole;
    },
    /* Sliding once, then rolling by each definition, on one scale. */
    bars(p, box, r) {
        const rows = [
            [word('ui.slides'), r.contacts[0].vs, p.slide, ''],
            ...SHOWN.map(k => [k, r.definitions.rolling[k], p.roll, word('who.means')[k]]),
            ['full-radius', r.definitions.sliding['full-radius'], p.slide, word('who.means')['full-radius']]
        ];
        const middle = box.x + .5 * box.w, gap = box.h / (rows.length + .5),
              most = Math.max(.3, ...rows.map(k => Math.abs(k[1])));
        rows.forEach(([name, value, colour_, means], i) => {
            const y = box.y + (i + .45) * gap, length = .45 * box.w * value / most;
            p.label(`${name} ${short(value)} m/s`, box.x, y, {size: .85, bold: true});
            p.label(means, box.x, y + .85 * p.em, {size: .6, colour: p.faint});
            p.c.fillStyle = colour_;
            p.c.fillRect(Math.min(middle, middle + length), y + 1.3 * p.em, Math.abs(length), .6 * p.em);
            p.c.fillStyle = p.ink, p.c.fillRect(middle - 1, y + 1.2 * p.em, 2, .8 * p.em);
        });
    },
    read({engine}, s) {
        const definitions = engine.measure(motion(s)), v = SHOWN.map(k => definitions.rolling[k]);
        const agree = Math.max(...v) - Math.min(...v) < 1e-3;
        return {
            contacts: [{vs: definitions.sliding.wang, vr: definitions.rolling.wang}],
            scale: 1,
            definitions,
            sentence: word(agree ? 'who.agree' : 'who.differ')
        };
    },
};
