/* SPDX-License-Identifier: MIT */
/* The scenes, in order; their states as the address holds them: #pair?w1=1&w2=-0.5 */
import {carpetScene} from './carpet.mjs';
import {coinScene} from './coin.mjs';
import {gearsScene} from './gears.mjs';
import {insideScene} from './inside.mjs';
import {pairScene} from './pair.mjs';
import {rimScene} from './rim.mjs';
import {sampleScene} from './sample.mjs';
import {slopeScene} from './slope.mjs';
import {thiefScene} from './thief.mjs';
import {throwScene} from './throw.mjs';
import {wheelsScene} from './wheels.mjs';
import {whoScene} from './who.mjs';

export const SCENES = [
    rimScene, wheelsScene, pairScene, coinScene, throwScene, carpetScene, whoScene, thiefScene, slopeScene, gearsScene,
    insideScene, sampleScene
];

/* Inside its range; {value, limited}. NaN: the default. */
export function limit(control, value) {
    if (control.choices) return control.choices.includes(value) ? {value} : {value: control.value, limited: true};
    const x = Number(value);
    if (value === '' || !isFinite(x)) return {value: control.value, limited: true};
    const inside = Math.min(control.max, Math.max(control.min, x));
    return {value: inside, limited: inside !== x};
}

export function defaults(scene) {
    return Object.fromEntries(scene.controls.map(c => [c.key, c.value]));
}

export function toAddress(scene, state) {
    const changed =
        scene.controls.filter(c => state[c.key] !== c.value).map(c => `${c.key}=${encodeURIComponent(state[c.key])}`);
    return '#' + scene.id + (changed.length ? '?' + changed.join('&') : '');
}

/* {scene, state, wrong}: wrong is what was not understood. An empty address is the first scene. */
export function fromAddress(address) {
    const [id, query = ''] = address.replace(/^#/, '').split('?');
    const scene = SCENES.find(s => s.id === id), wrong = [];
    if (!scene) return {scene: SCENES[0], state: defaults(SCENES[0]), wrong: id ? [id] : []};
    const state = defaults(scene);
    for (const [key, value] of new URLSearchParams(query)) {
        const control = scene.controls.find(c => c.key === key);
        if (!control) {
            wrong.push(key);
            continue;
        }
        const got = limit(control, value);
        state[key] = got.value;
        if (got.limited) wrong.push(`${key}=${value}`);
    }
    return {scene, state, wrong};
}
