// coarse.js - how coarse a picture must be while the view moves: as coarse as the last ones' times ask for.

const FACTORS = [1, 1.25, 1.5, 2, 2.5, 3, 4, 5, 6, 8, 10, 12, 16, 24, 32];
const FULL_TIME = 30; // milliseconds that a picture may take at full resolution,
const COARSE_TIME = 16; // and at any coarser one
const SURE = 0.8; // of these times, before it becomes finer again
const OVERHEAD = 1; // milliseconds of each picture, however coarse
const GROWTH = 0.5; // a pixel of a coarser picture takes that power of the factor longer: there is more in it
const TRUST = 0.4; // in the last picture, of one: other programs take their time, too
const SLOWEST = 10; // milliseconds a pixel
const FIRST_GUESS = 5e-4; // milliseconds a pixel, of one worker whose code is not compiled yet

export class Coarseness {
    factor = 1;
    msPerPixel = FIRST_GUESS;

    /** The factor for a picture of that size by so many workers. */
    choose(width, height, workers) {
        const perPixel = (factor) => this.msPerPixel * factor ** GROWTH;
        const time = (factor) => OVERHEAD + (perPixel(factor) * width * height) / (factor * factor) / workers;
        const limit = (factor) =>
            (factor === 1 ? FULL_TIME : COARSE_TIME) * (factor < this.factor ? SURE : 1);
        this.factor = FACTORS.find((factor) => time(factor) <= limit(factor)) ?? FACTORS.at(-1);
        return this.factor;
    }

    /** From a picture that is done. */
    learn(drawing) {
        const measured = drawing.workMsPerPixel / drawing.factor ** GROWTH;
        this.msPerPixel += TRUST * (measured - this.msPerPixel);
    }

    /** Nothing came in time: the coarsest picture is next. */
    slowest() {
        this.msPerPixel = SLOWEST;
    }

    /** A picture was given up: it is at least as slow as its bands were. */
    late(drawing) {
        this.msPerPixel = Math.max(2 * this.msPerPixel, drawing.workMsPerPixel);
    }
}
