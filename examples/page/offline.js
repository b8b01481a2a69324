// offline.js - the page's service worker: after the first load it needs no network.
//
// All files of one version are fetched together and belong together: pages opened from this version get it to
// their end, a newer one takes its place when none of them is open any more.  The build writes version and
// files.
const VERSION = "development";
const FILES = [];

const family = `algsurf ${self.registration.scope} `; // caches are shared by all folders of a host
const name = family + VERSION;

async function fill() {
    const cache = await caches.open(name);
    await cache.addAll(["./", ...FILES].map((file) => new Request(file, { cache: "reload" })));
}

async function removeOlder() {
    for (const other of await caches.keys())
        if (other.startsWith(family) && other !== name) await caches.delete(other);
}

async function answer(request) {
    const cache = await caches.open(name);
    return (await cache.match(request, { ignoreSearch: true })) ?? fetch(request);
}

self.addEventListener("install", (event) => event.waitUntil(fill()));
self.addEventListener("activate", (event) => event.waitUntil(removeOlder()));
self.addEventListener("fetch", (event) => {
    const { method, url } = event.request;
    if (method === "GET" && url.startsWith(self.registration.scope)) event.respondWith(answer(event.request));
});
