// Bits of the edges between a pixel and its neighbours: the low four bits of the pixel's byte for the pixel to the
// right, the high four for the pixel below. src/raster/pair_mark.h has the same bits; a test holds the two together.
const uint BACKGROUND = 1u;  // one of the two sees no surface
const uint PATCH = 2u;       // the patches differ
const uint BEND = 4u;        // the faces bend by more than the crease angle
const uint JUMP = 8u;        // one surface lies in front of the other
