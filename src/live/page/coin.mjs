/* SPDX-License-Identifier: MIT */
/* Scene 3: a coin rolls around another without sliding. How often does it turn? */
import {short} from './draw.mjs';
import {word} from './words.mjs';

const COIN = .1, RATE = 1; /* radius of the rolling coin [m]; it goes around at this rate [rad/s] */

export const coinScene = {
    id: 'coin',
    seconds: 6.283,
    pace: 1,
    controls: [
        {key: 'ratio', name: 'R₁/R₂', unit: '', min: 1, max: 10, step: 1, value: 1},
        {key: 'ride', name: 'ride', choices: ['no', 'yes'], value: 'no', free: true}
    ],
    text: s => `# ${word('scene.coin.title')}\nkind: bodies\ntime_end: ${coinScene.seconds} s\n` +
               'contact: {k_n: 1 MPa, friction: none, rolling: none}\nstep: {dt: 1 ms}\ndisks:\n' +
               `  - {radius: ${COIN}*${s.ratio} m, x: 0, y: 0, motion: prescribed}\n` +
               `  - {radius: ${COIN} m, x: disks.0.radius + radius - 1 um, y: 0, motion: orbit, orbit: ${
                   RATE} rad/s, spin: (1 + disks.0.radius/radius)*orbit}\n` +
               'output: {frames: 100, rows: 101, contacts: 11}\n',
    begin: () => ({}),
    draw(p, {world}, s, r) {
        const a = world.disk(0), b = world.disk(1), beta = RATE * world.time(), back = s.ride === 'yes' ? -beta : 0;
        const reach = a.radius + 2.2 * b.radius, x = Math.hypot(b.x, b.y) * Math.cos(beta + back),
              y = Math.hypot(b.x, b.y) * Math.sin(beta + back);
        p.view(0, 0, reach, reach);
        p.circle(0, 0, a.radius, {fill: p.fill, stroke: p.ink});
        p.arc(0, 0, a.radius, back, beta + back, p.ink, .35);
        p.circle(x, y, b.radius, {fill: p.fill, stroke: p.ink});
        p.arrow(x, y, .9 * b.radius * Math.cos(b.angle + Math.PI + back),
                .9 * b.radius * Math.sin(b.angle + Math.PI + back), p.ink, {width: .2});
        if (!r.tell) return;
        p.circle(a.radius * Math.cos(beta + back), a.radius * Math.sin(beta + back), .09 * b.radius, {fill: p.roll});
        p.text(word('coin.turns', {turns: short(b.angle / (2 * Math.PI))}), 0, 0);
    },
    read({world, engine}, s) {
        const a = world.disk(0), b = world.disk(1), turns = b.angle / (2 * Math.PI),
              rim = turns * s.ratio / (1 + s.ratio);
        const definitions =
            engine.measure({R1: a.radius, R2: b.radius, w1: 0, x2: b.x, y2: b.y, vx2: b.vx, vy2: b.vy, w2: b.spin});
        return {
            contacts: [{vs: definitions.sliding.wang, vr: definitions.rolling.wang}],
            scale: Math.abs(RATE * a.radius),
            definitions,
            lines: [
                [word('coin.all'), short(turns)], [word('coin.rim'), short(rim)],
                [word('coin.around'), short(turns - rim)]
            ],
            sentence: word('coin.sentence', {sum: 1 + s.ratio, ratio: s.ratio})
        };
    },
};
