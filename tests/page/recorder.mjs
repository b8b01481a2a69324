// recorder.mjs - the reports of all pictures that are shown, with the time of each.
export class Recorder {
    #visit;

    static async start(visit) {
        await visit.page.evaluate(() => {
            const record = [];
            const end = window.algsurfPage.store.subscribe(({ picture }, { changed }) => {
                if (changed.has("picture")) record.push({ ...picture, state: null, at: performance.now() });
            });
            window.algsurfRecord = { record, end };
        });
        const recorder = new Recorder();
        recorder.#visit = visit;
        return recorder;
    }

    /** The reports so far; no more are recorded. */
    stop() {
        return this.#visit.page.evaluate(() => {
            window.algsurfRecord.end();
            return window.algsurfRecord.record;
        });
    }
}
