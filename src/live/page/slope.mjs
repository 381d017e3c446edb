/* SPDX-License-Identifier: MIT */
/* Scene 7: a disk on a slope. A map shows where it rests, rolls and slips, a point where it is. */
import {drawWheel, floorMotion, WHEEL} from './rim.mjs';
import {short} from './draw.mjs';
import {word} from './words.mjs';

const GRAVITY = 9.81;
/* Each law: its keys; the slope tan(alpha) from which it slips while it rolls [cases/incline-*.yaml]; the slope that
 * friction alone can hold; the acceleration while it slips. Friction mu N acts with the law's T: a moment T R, or a
 * moment T R/2 and a force T/2. With the latter a disk may spin backwards, so fast that no
 * material flows through the contact on average:
 * d(R w)/dt = (T - 2 mu N)/m = dv/dt; T is then below its bound. */
const LAWS = {
    wang: {
        keys: 'rolling: wang-spring, rolling_velocity: wang',
        slips: (mu, r) => 3 * mu - 2 * r,
        holds: mu => mu,
        slides: (down, press, mu) => down - mu * press
    },
    'bagi-kuhn': {
        keys: 'rolling: conjugate-spring, rolling_velocity: bagi-kuhn',
        slips: (mu, r) => 3 * mu - r / 2,
        holds: mu => 2 * mu,
        slides: (down, press, mu, r) =>
            2 / 3 * (down + mu * press) <= r * press ? 2 / 3 * down - 4 / 3 * mu * press : down - (mu + r / 2) * press
    },
};

/* Rests up to mu_r, or to what friction holds where that is less: then it slips without rolling. */
function fate(s) {
    const tan = Math.tan(s.slope * Math.PI / 180), rests = Math.min(LAWS[s.law].holds(s.mu), s.mu_r);
    if (tan <= rests) return 'rests';
    if (rests < s.mu_r) return 'slips';
    return tan <= LAWS[s.law].slips(s.mu, s.mu_r) ? 'rolls' : 'slips';
}

/* Closed forms of the acceleration down the slope. */
function exact(s) {
    const a = s.slope * Math.PI / 180, down = GRAVITY * Math.sin(a), press = GRAVITY * Math.cos(a);
    switch (fate(s)) {
    case 'rests': return 0;
    case 'rolls': return 2 / 3 * (down - s.mu_r * press);
    default: return LAWS[s.law].slides(down, press, s.mu, s.mu_r);
    }
}

export const slopeScene = {
    id: 'slope',
    seconds: .6,
    pace: .3,
    controls: [
        {key: 'slope', name: 'α', unit: '°', min: 0, max: 60, step: .5, value: 25},
        {key: 'mu', name: 'μ', unit: '', min: 0, max: .6, step: .01, value: .3},
        {key: 'mu_r', name: 'μ_r', unit: '', min: 0, max: .4, step: .01, value: .1},
        {key: 'law', name: 'law', choices: Object.keys(LAWS), value: 'wang'},
    ],
    /* The floor stays level in these numbers, and gravity leans. */
    text: s => `# ${word('scene.slope.title')}\nkind: bodies\ntime_end: ${slopeScene.seconds} s\ngravity:\n` +
               `  x: ${GRAVITY} m/s^2*sin(${s.slope} deg)\n  y: -${GRAVITY} m/s^2*cos(${s.slope} deg)\n` +
               `contact: {k_n: 100 MPa, k_t: 100 MPa, damping_ratio: 0.3, mu: ${s.mu}, mu_r: ${s.mu_r}, k_r: 100 MPa, ${
                   LAWS[s.law].keys}}\n` +
               `disks:\n  - {radius: ${
                   WHEEL} m, density: 1200 kg/m^3, x: 0, y: radius + density*pi*radius^2*gravity.y/contact.k_n}\n` +
               'walls:\n  - {nx: 0, ny: 1}\noutput: {frames: 100, rows: 101, contacts: 11, curve: speed}\n',
    begin: world => ({start: world.disk(0)}),
    draw(p, {world, memory}, s, r) {
        const whole = p.box, d = world.disk(0), a = s.slope * Math.PI / 180;
        p.view(d.x, .1, .6, .6, {x: whole.x, y: whole.y, w: .58 * whole.w, h: whole.h});
        p.c.save();
        p.c.beginPath(), p.c.rect(p.box.x, p.box.y, p.box.w, p.box.h), p.c.clip();
        p.c.translate(p.px(d.x), p.py(0)), p.c.rotate(a), p.c.translate(-p.px(d.x), -p.py(0));
        drawWheel(p, d, memory.start, {...r.contacts[0], ...r, chalk: false});
        p.c.restore();
        const view = [p.x0, p.y0, p.scale];
        this.map(p, {x: whole.x + .58 * whole.w, y: whole.y, w: .42 * whole.w, h: whole.h}, s, r);
        [p.x0, p.y0, p.scale] = view, p.box = whole;
    },
    /* mu_r to the right, tan(alpha) upward. */
    map(p, box, s, r) {
        const top = Math.max(1.2, 3.2 * s.mu), points = n => Array.from({length: 41}, (_, k) => n(.4 * k / 40));
        const holds = LAWS[s.law].holds(s.mu), slips = x => x < holds ? LAWS[s.law].slips(s.mu, x) : holds;
        p.chart(box, {x: [0, .4], y: [0, Math.min(1.8, top)], xName: 'μ_r', yName: 'tan α', curves: r.tell ? [
            {points: points(x => [x, Math.min(x, holds)]), colour: p.faint},
            {points: points(x => [x, slips(x)]), colour: p.ink}] : [],
        dots: [[s.mu_r, Math.tan(s.slope * Math.PI / 180)]],
        texts: r.tell ? [
            [.32, .06, word('slope.rests')], [.05, .3 + .5 * s.mu, word('slope.rolls')],
            [.3, Math.min(1.7, .9 * top), word('slope.slips')]
        ] : []});
    },
    read({world, engine}, s) {
        const d = world.disk(0), definitions = engine.measure(floorMotion(d)), t = world.time();
        const vs = definitions.sliding.wang, vr = definitions.rolling.wang,
              still = Math.abs(vs) < .01 * (1 + Math.abs(d.vx));
        return {
            contacts: [{vs: still ? 0 : vs, vr: Math.abs(vr) < .01 ? 0 : vr}],
            scale: 2,
            definitions,
            lines: [
                [word('slope.measured'), `${short(t ? d.vx / t : NaN)} m/s²`],
                [word('slope.exact'), `${short(exact(s))} m/s²`]
            ],
            sentence: word('slope.' + fate(s) + 'Now')
        };
    },
};
