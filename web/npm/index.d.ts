// Types of the npm package.

/**
 * Options of the command `lacuna sample` or `lacuna stipple`, in camelCase; a flag is true.
 * `{ count: 2000, sizeByTone: 0.5, invert: true }` is `--count 2000 --size-by-tone 0.5 --invert`.
 */
export type Options = Record<string, string | number | bigint | boolean | readonly string[] | undefined>;

export interface PointSet {
    /** x and y of each point, one after the other; y is upwards. */
    points: Float64Array;
    /** The size of the domain, in the unit of the points. */
    width: number;
    height: number;
    /** No two points are closer; 0 if the distance is not known. */
    radius: number;
}

/** RGBA, row by row from the top, as in a canvas's ImageData. */
export interface Image {
    width: number;
    height: number;
    data: Uint8Array | Uint8ClampedArray;
}

/** The dots of an ink; they come ink by ink. */
export interface Layer {
    dots: number;
    /** 0xrrggbb */
    colour: number;
    opaque: 0 | 1;
}

export interface Stippling extends PointSet {
    /** One for each point, in the unit of the points; null if all dots are equal. */
    diameters: Float64Array | null;
    /** Empty without `inks`. */
    layers: Layer[];
}

/** The points of `lacuna sample`. Throws an Error that names the option and what it must be. */
export function sample(options?: Options): PointSet;

/** The dots of `lacuna stipple` on this image. Throws an Error as sample does. */
export function stipple(image: Image, options?: Options): Stippling;
