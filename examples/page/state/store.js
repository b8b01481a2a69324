// store.js - the one state of the page, and who wants to know of its changes.
//
// A state is replaced, never changed: get() may be kept.  Subscribers hear
//     change(state, { changed: Set of keys, moving })
// moving: more is to come at once (a drag, a slider), a coarse picture will do.
export class Store {
    #state;
    #subscribers = new Set();

    constructor(state) {
        this.#state = Object.freeze({ ...state });
    }

    get() {
        return this.#state;
    }

    set(partial, { moving = false } = {}) {
        this.#state = Object.freeze({ ...this.#state, ...partial });
        const how = { changed: new Set(Object.keys(partial)), moving };
        for (const change of [...this.#subscribers]) change(this.#state, how);
    }

    /** Returns a function that ends the subscription. */
    subscribe(change) {
        this.#subscribers.add(change);
        return () => this.#subscribers.delete(change);
    }
}
