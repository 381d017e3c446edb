// SPDX-License-Identifier: MIT
// Drives a page in headless Chromium by keys, over its debugging pipe.
// usage: node browser.js PROFILE WIDTH HEIGHT URL [FLAGS...] <COMMANDS     one line each:
//   key NAME       presses it: PageDown, r, 1, ?, " "      eval EXPRESSION    prints its value, of a promise too
//   until EXPR     waits, 10 s at most, and prints it      shot FILE, pdf FILE
// Console messages and exceptions are printed as "console: ...". Ends with 1 if the browser does.
"use strict";
const {spawn} = require("child_process");
const fs = require("fs");
const [profile, width, height, url, ...flags] = process.argv.slice(2);
const browser = spawn("chromium", ["--headless", "--no-sandbox", "--disable-gpu", "--hide-scrollbars", "--remote-debugging-pipe",
    "--user-data-dir=" + profile, `--window-size=${width},${height}`, ...flags, "about:blank"],
    {stdio: ["ignore", "ignore", "ignore", "pipe", "pipe"]});
const out = browser.stdio[3], input = browser.stdio[4], waiting = new Map();
let last = 0, rest = "", session;
const say = text => fs.writeSync(1, text + "\n");
browser.on("exit", () => process.exit(1));
input.on("data", data => {
    rest += data;
    for (let end; (end = rest.indexOf("\0")) >= 0; rest = rest.slice(end + 1)) take(JSON.parse(rest.slice(0, end)));
});
function take(message) {
    if (message.id) {
        waiting.get(message.id)(message);
        waiting.delete(message.id);
    } else if (message.method === "Runtime.consoleAPICalled") say("console: " + message.params.args.map(a => a.value).join(" "));
    else if (message.method === "Runtime.exceptionThrown") say("console: " + message.params.exceptionDetails.text);
}
function ask(method, params = {}) {
    const id = ++last;
    out.write(JSON.stringify({id, method, params, sessionId: session}) + "\0");
    return new Promise(done => waiting.set(id, done));
}
async function value(expression) {
    const r = await ask("Runtime.evaluate", {expression, awaitPromise: true, returnByValue: true});
    return r.result.exceptionDetails ? "exception: " + r.result.exceptionDetails.exception.description : r.result.result.value;
}
const codes = {PageDown: 34, PageUp: 33, " ": 32, ArrowRight: 39, ArrowLeft: 37, ArrowDown: 40, Escape: 27, Tab: 9, Enter: 13};
const sleep = ms => new Promise(done => setTimeout(done, ms));
async function command(line) {
    const name = line.split(" ", 1)[0], rest = line.slice(name.length + 1);
    if (name === "key") {
        const key = rest === "Space" ? " " : rest, text = key.length === 1 ? key : undefined;
        const code = codes[key] || key.toUpperCase().charCodeAt(0);
        await ask("Input.dispatchKeyEvent", {type: "keyDown", key, text, windowsVirtualKeyCode: code});
        await ask("Input.dispatchKeyEvent", {type: "keyUp", key, windowsVirtualKeyCode: code});
        await sleep(50);
    } else if (name === "eval") say(String(await value(rest)));
    else if (name === "until") {
        let v = false;
        for (let k = 0; k < 100 && !v; k++) if (!(v = await value(rest))) await sleep(100);
        say(String(v));
    } else if (name === "shot") {
        await sleep(500);
        fs.writeFileSync(rest, Buffer.from((await ask("Page.captureScreenshot")).result.data, "base64"));
    } else if (name === "pdf") {
        fs.writeFileSync(rest, Buffer.from((await ask("Page.printToPDF", {preferCSSPageSize: true})).result.data, "base64"));
    } else say("no command: " + line);
}
async function main() {
    const target = await ask("Target.createTarget", {url: "about:blank"});
    session = (await ask("Target.attachToTarget", {targetId: target.result.targetId, flatten: true})).result.sessionId;
    await ask("Page.enable");
    await ask("Runtime.enable");
    await ask("Emulation.setDeviceMetricsOverride", {width: Number(width), height: Number(height), deviceScaleFactor: 1, mobile: false});
    await ask("Page.navigate", {url});
    for (let k = 0; k < 100 && (await value("document.readyState")) !== "complete"; k++) await sleep(100);
    for (const line of fs.readFileSync(0, "utf8").split("\n")) if (line.trim()) await command(line);
    browser.removeAllListeners("exit");
    browser.kill("SIGKILL");
    process.exit(0);
}
main();
