/* SPDX-License-Identifier: MIT */
/* Scene 4b: a disk is thrown along ice, and comes onto a carpet [cases/ice-and-carpet.yaml]. */
import {short} from './draw.mjs';
import {WHEEL} from './rim.mjs';
import {throwScene} from './throw.mjs';
import {word} from './words.mjs';

const ICE = .6; /* length of ice before it [m] */

export const carpetScene = {
    ...throwScene,
    id: 'carpet',
    seconds: 2,
    controls: [
        {key: 'mu', name: 'μ', unit: '', min: 0, max: 1, step: .01, value: .02},
        {key: 'mu2', name: 'μ', unit: '', min: 0, max: 1, step: .01, value: .3},
        {key: 'v', name: 'v₀', unit: 'm/s', min: -2, max: 2, step: .01, value: 1},
        {key: 'w', name: 'ω₀', unit: 'rad/s', min: -20, max: 20, step: .1, value: 0},
    ],
    text: s => throwScene.text({...s, shape: 'disk', x: -ICE})
                   .replace(/^# .*/, `# ${word('scene.carpet.title')}`)
                   .replace(/time_end: .*/, `time_end: ${carpetScene.seconds} s`)
                   .replace('- {nx: 0, ny: 1}',
                            `- {nx: 0, ny: 1, to: 0}\n  - {nx: 0, ny: 1, from: 0, contact: {mu: ${s.mu2}}}`),
    draw(p, run, s, r) {
        const d = run.world.disk(0);
        throwScene.draw.call(this, p, run, s, r);
        p.path([[d.x - 20 * WHEEL, -.015], [0, -.015]], p.line, .3);
        p.path([[0, -.015], [d.x + 20 * WHEEL, -.015]], p.faint, .6);
        p.path([[0, -.04], [0, .56]], p.faint, .06);
        for (const [align, edge] of [['left', 0], ['right', p.width]]) {
            const ice = edge < p.px(0), name = word(ice ? 'carpet.ice' : 'carpet.carpet');
            p.label(`${name} μ = ${short(ice ? s.mu : s.mu2)}`, edge, p.py(.05), {align, colour: p.faint});
        }
    },
};
