/* SPDX-License-Identifier: MIT */
/* Scene 4: a disk or a sphere is thrown along a floor, with spin or without. */
import {lampOf} from './gauge.mjs';
import {drawMotion, drawWheel, floorMotion, WHEEL} from './rim.mjs';

import {short} from './draw.mjs';
import {word} from './words.mjs';

const G = 9.81;

export const throwScene = {
    id: 'throw',
    seconds: 1.5,
    pace: .4,
    controls: [
        {key: 'mu', name: 'μ', unit: '', min: 0, max: 1, step: .01, value: .1},
        {key: 'v', name: 'v₀', unit: 'm/s', min: -2, max: 2, step: .01, value: 1},
        {key: 'w', name: 'ω₀', unit: 'rad/s', min: -20, max: 20, step: .1, value: 0},
        {key: 'shape', name: 'shape', choices: ['disk', 'sphere'], value: 'disk'},
    ],
    /* It rests on its contact, so that it does not bounce. */
    text(s) {
        const weight = s.shape === 'sphere' ? '4/3*density*pi*radius^3' : 'density*pi*radius^2',
              k = s.shape === 'sphere' ? '100 MN/m' : '100 MPa';
        return `# ${word('scene.throw.title')}\nkind: bodies\nshape: ${s.shape}\ngravity: {x: 0, y: -${
                   G} m/s^2}\ntime_end: ${throwScene.seconds} s\n` +
               `contact: {k_n: ${k}, damping_ratio: 0.3, friction: coulomb-spring, mu: ${
                   s.mu}, rolling: none}\ndisks:\n` +
               `  - {radius: ${WHEEL} m, density: 1200 kg/m^3, x: ${s.x ?? 0} m, y: radius - ${weight}*${
                   G} m/s^2/contact.k_n, vx: ${s.v} m/s, spin: ${s.w} rad/s}\n` +
               'walls:\n  - {nx: 0, ny: 1}\noutput: {frames: 100, rows: 101, contacts: 101, curve: velocities}\n';
    },
    begin: world => ({start: world.disk(0), v: [], rim: []}),
    after({world, memory}) {
        const d = world.disk(0), t = world.time();
        memory.v.push([t, d.vx]), memory.rim.push([t, -d.spin * d.radius]);
    },
    draw(p, {world, memory}, s, r) {
        const d = world.disk(0), whole = p.box,
              low = Math.min(-.1, ...memory.v.map(x => x[1]), ...memory.rim.map(x => x[1]));
        const high = Math.max(.1, ...memory.v.map(x => x[1]), ...memory.rim.map(x => x[1])), gap = .1 * (high - low);
        p.view(d.x, .17, .75, .42, {x: whole.x, y: whole.y, w: whole.w, h: .56 * whole.h});
        drawWheel(p, d, memory.start, {...r.contacts[0], ...r, chalk: false});
        drawMotion(p, d);
        p.chart({x: whole.x, y: whole.y + .58 * whole.h, w: whole.w, h: .42 * whole.h}, {
            x: [0, this.seconds],
            y: [low - gap, high + gap],
            xName: word('throw.time'),
            yName: word('throw.speeds'),
            curves: [
                {points: memory.v, colour: p.ink, name: 'v'},
                {points: memory.rim, colour: p.faint, dash: true, name: '−R ω'}
            ]
        });
        p.box = whole;
    },
    read({world, memory, engine}, s) {
        const d = world.disk(0), definitions = engine.measure(floorMotion(d)), scale = 1;
        const vs = definitions.sliding.wang, vr = definitions.rolling.wang;
        const inertia = (s.shape === 'sphere' ? .4 : .5) * d.mass * d.radius ** 2,
              energy = q => [.5 * d.mass * q.vx ** 2, .5 * inertia * q.spin ** 2];
        const [moves, spins] = energy(d), all = energy(memory.start)[0] + energy(memory.start)[1] || 1;
        const percent = x => `${Math.round(100 * x / all)} %`;
        /* Its springs still swing a little when it rolls: a hundredth counts as rolling. */
        const still = Math.abs(vs) < .01 * Math.max(Math.abs(s.v), Math.abs(s.w) * WHEEL);
        return {
            contacts: [{vs: still ? 0 : vs, vr}],
            scale,
            definitions,
            lines: [
                [word('throw.moves'), percent(moves)], [word('throw.spins'), percent(spins)],
                [word('throw.heat'), percent(Math.max(0, all - moves - spins))]
            ],
            sentence: still && s.v ? word('throw.ends', {share: short(d.vx / s.v)})
                                   : word('throw.' + lampOf(vs, vr, scale))
        };
    },
    handles({world}, s) {
        if (world.steps) return [];
        const d = world.disk(0);
        return [{key: 'v', x: d.x + .35 * s.v, y: d.y, value: x => (x - d.x) / .35}];
    },
};
