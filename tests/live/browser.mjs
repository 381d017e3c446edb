// SPDX-License-Identifier: MIT
// A headless Chromium by its pipe: no further package is needed.
import {spawn} from 'node:child_process';

export async function openBrowser(program, folder) {
    const child = spawn(
        program,
        ['--headless=new', '--no-sandbox', '--disable-gpu', '--remote-debugging-pipe', `--user-data-dir=${folder}`],
        {stdio: ['ignore', 'ignore', 'ignore', 'pipe', 'pipe']});
    const waiting = new Map(), said = [];
    let id = 0, rest = '';
    child.stdio[4].on('data', data => {
        const parts = (rest + data).split('\0');
        rest = parts.pop();
        for (const message of parts.map(part => JSON.parse(part))) {
            if (waiting.has(message.id))
                waiting.get(message.id)(message), waiting.delete(message.id);
            else if (['Runtime.consoleAPICalled', 'Runtime.exceptionThrown', 'Log.entryAdded'].includes(message.method))
                said.push(JSON.stringify(message.params));
        }
    });
    const raw = (method, params, sessionId) => new Promise((done, failed) => {
        waiting.set(++id, message => message.error ? failed(new Error(`${method}: ${message.error.message}`))
                                                   : done(message.result));
        child.stdio[3].write(JSON.stringify({id, method, params, sessionId}) + '\0');
    });
    const {targetId} = await raw('Target.createTarget', {url: 'about:blank'});
    const {sessionId} = await raw('Target.attachToTarget', {targetId, flatten: true});
    const send = (method, params = {}) => raw(method, params, sessionId);
    for (const domain of ['Page', 'Runtime', 'Log']) await send(`${domain}.enable`);

    const mouse = (type, x, y) => send('Input.dispatchMouseEvent', {type, x, y, button: 'left', clickCount: 1});
    const browser = {
        said,
        send,
        close: () => raw('Browser.close').catch(() => {}),
        size: (width, height) =>
            send('Emulation.setDeviceMetricsOverride', {width, height, deviceScaleFactor: 1, mobile: false}),
        dark: on => send('Emulation.setEmulatedMedia',
                         {features: [{name: 'prefers-color-scheme', value: on ? 'dark' : 'light'}]}),
        async evaluate(expression) {
            const {result, exceptionDetails} =
                await send('Runtime.evaluate', {expression, awaitPromise: true, returnByValue: true});
            if (exceptionDetails) throw new Error(exceptionDetails.exception?.description ?? exceptionDetails.text);
            return result.value;
        },
        async key(key) {
            const what = {
                key,
                text: key.length === 1 ? key : undefined,
                windowsVirtualKeyCode: {Escape: 27, PageUp: 33, PageDown: 34}[key]
            };
            await send('Input.dispatchKeyEvent', {type: 'keyDown', ...what});
            await send('Input.dispatchKeyEvent', {...what, type: 'keyUp', text: undefined});
        },
        async drag(from, to) {
            await mouse('mousePressed', ...from);
            for (let k = 1; k <= 5; k++)
                await mouse('mouseMoved', from[0] + (to[0] - from[0]) * k / 5, from[1] + (to[1] - from[1]) * k / 5);
            await mouse('mouseReleased', ...to);
        },
        /* Until an expression is true in the page; a busy machine may take a while. */
        async until(expression, seconds = 120) {
            for (const end = Date.now() + 1000 * seconds; Date.now() < end;) {
                if (await browser.evaluate(expression)) return;
                if (said.length) break;
                await new Promise(done => setTimeout(done, 50));
            }
            throw new Error(said.length ? said[0] : `not within ${seconds} s: ${expression}`);
        },
        async open(url, ready) {
            await send('Page.navigate', {url});
            await browser.until(ready);
        },
        shot: async () => Buffer.from((await send('Page.captureScreenshot')).data, 'base64'),
    };
    return browser;
}
