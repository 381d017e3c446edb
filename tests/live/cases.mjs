// SPDX-License-Identifier: MIT
// The cases that "case.yaml" gives, of each scene as it opens and with values from all over their ranges, into files;
// those of one contact into DIRECTORY/path.
// usage: node cases.mjs PAGE DIRECTORY
import {readFileSync, writeFileSync} from 'node:fs';
const [page, out] = process.argv.slice(2);
globalThis.WORDS = JSON.parse(readFileSync(`${page}/words.en.json`, 'utf8'));
const {SCENES, defaults, fromAddress, limit, toAddress} = await import(`${page}/show.mjs`);

let seed = 1;
const random = () => (seed = (seed * 48271) % 2147483647) / 2147483647; // Lehmer's, as in C++'s minstd_rand

for (const scene of SCENES)
    for (let k = 0; k < (scene.slow ? 2 : 12); k++) {
        const state = defaults(scene);
        for (const c of k ? scene.controls : [])
            state[c.key] =
                c.choices
                    ? c.choices[Math.floor(random() * c.choices.length)]
                    : limit(c, Number((Math.round((c.min + random() * (c.max - c.min)) / c.step) * c.step).toFixed(6)))
                          .value;
        const back = fromAddress(toAddress(scene, state)); // the address holds all of it
        if (back.wrong.length || back.scene !== scene ||
            scene.controls.some(c => String(back.state[c.key]) !== String(state[c.key])))
            throw new Error(`the address of ${scene.id} lost something: ${toAddress(scene, state)}`);
        writeFileSync(`${out}/${scene.open ? 'path/' : ''}${scene.id}-${k}.yaml`, scene.text(state));
        if (scene.other?.(state)) writeFileSync(`${out}/${scene.id}-${k}-b.yaml`, scene.other(state));
    }

// What is outside of its range stops at the limit; nonsense opens the first scene and is named.
const check = (what, address, id, wrong) => {
    const got = fromAddress(address);
    if (got.scene.id !== id || got.wrong.join() !== wrong)
        throw new Error(`${what}: ${got.scene.id}, ${got.wrong.join()}`);
};
check('nothing', '', 'rim', '');
check('an unknown scene', '#nonsense?v=1', 'rim', 'nonsense');
check('an unknown key', '#pair?w9=1&w1=2', 'pair', 'w9');
check('outside of the range', '#rim?v=99', 'rim', 'v=99');
check('no number', '#rim?v=fast', 'rim', 'v=fast');
check('no choice', '#sample?definition=mine', 'sample', 'definition=mine');
if (fromAddress('#rim?v=99').state.v !== 1) throw new Error('99 did not stop at the limit');
