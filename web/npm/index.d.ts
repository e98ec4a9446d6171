// Types of the npm package.

/** A number, or a text as on the command line, such as "20k". */
export type Numeric = number | bigint | string;

/** Parts of a list; a text has commas between them. */
export type List = string | readonly (string | number)[];

/**
 * What both functions have: options of the command, in camelCase. `lacuna sample --help-all` says
 * what each means; a flag is true.
 */
export interface Options {
    count?: Numeric;
    scale?: Numeric;
    torus?: boolean;
    limit?: Numeric;
    seed?: Numeric;
    relax?: Numeric;
    linesPerRadius?: Numeric;
    roundSize?: Numeric;
    threads?: Numeric;
    backend?: "auto" | "cpu";
    device?: string;
}

/** `{ count: 2000, onPixels: "64x64" }` is `--count 2000 --on-pixels 64x64`. */
export interface SampleOptions extends Omit<Options, "scale"> {
    radius?: Numeric;
    domain?: string;
    onPixels?: string;
    border?: Numeric;
    progressive?: boolean;
    mode?: "exact" | "lines" | "stratified";
    uniformX?: boolean;
    snap?: boolean;
}

/** `{ count: 2000, sizeByTone: 0.5, invert: true }` is `--count 2000 --size-by-tone 0.5 --invert`. */
export interface StippleOptions extends Options {
    metric?: "min" | "mean" | "max";
    turn?: Numeric;
    crop?: List;
    invert?: boolean;
    light?: boolean;
    black?: Numeric;
    white?: Numeric;
    background?: "white" | "black";
    autoLevels?: boolean;
    sharpen?: Numeric;
    along?: Numeric;
    gamma?: Numeric;
    minImportance?: Numeric;
    mode?: "stratified" | "cells" | "exact";
    inks?: List;
    blackInk?: Numeric;
    paperColour?: string;
    inkCounts?: List;
    dotSize?: string;
    pens?: List;
    pen?: string;
    dotStyle?: "spiral" | "circle";
    paperSize?: string;
    margin?: string;
    sizeByTone?: Numeric;
    keepInside?: boolean;
    penPath?: boolean;
    noPenPath?: boolean;
    pathLine?: boolean;
    plotTime?: string;
    secondsPerDot?: Numeric;
    secondsPerMetreDown?: Numeric;
    secondsPerMetreUp?: Numeric;
    secondsPerCorner?: Numeric;
}

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
export function sample(options?: SampleOptions): PointSet;

/** The dots of `lacuna stipple` on this image. Throws an Error as sample does. */
export function stipple(image: Image, options?: StippleOptions): Stippling;
