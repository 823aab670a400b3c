// Low-discrepancy points in the unit square: Hammersley sets and Owen-scrambled Sobol' sequences.
//
// All are pure functions of index and seed, so any thread may ask for any point and gets the same bits. Points lie in
// [0, 1)^2 on a grid of 2^-24.
#pragma once

#include <burnish/base/types.h>

#include <cstdint>

namespace burnish {

inline uint32_t reverse_bits(uint32_t x) {
    x = ((x >> 1) & 0x55555555u) | ((x & 0x55555555u) << 1);
    x = ((x >> 2) & 0x33333333u) | ((x & 0x33333333u) << 2);
    x = ((x >> 4) & 0x0f0f0f0fu) | ((x & 0x0f0f0f0fu) << 4);
    x = ((x >> 8) & 0x00ff00ffu) | ((x & 0x00ff00ffu) << 8);
    return (x >> 16) | (x << 16);
}

/// The fraction x / 2^32, rounded down to a float below 1.
inline float unit_fraction(uint32_t x) { return static_cast<float>(x >> 8) * 0x1p-24f; }

/// A hash of 32 bits onto 32 bits, one to one; hashes of neighbouring integers are independent to the last bit, which the
/// cheaper two-round hashes miss and Owen scrambling shows. Source: Wellons 2018, "Prospecting for hash functions" (triple32).
inline uint32_t hash_bits(uint32_t x) {
    x ^= x >> 17;
    x *= 0xed5ad4bbu;
    x ^= x >> 11;
    x *= 0xac4c1b51u;
    x ^= x >> 15;
    x *= 0x31848babu;
    return x ^ (x >> 14);
}

/// A seed from two numbers, e.g. pixel and lobe.
inline uint32_t hash_bits(uint32_t x, uint32_t y) { return hash_bits(x ^ hash_bits(y + 0x9e3779b9u)); }

/// The digits of i mirrored at the binary point: van der Corput's sequence.
inline float radical_inverse(uint32_t i) { return unit_fraction(reverse_bits(i)); }

/// Point i of the Hammersley set of `count` points: ((i + 1/2) / count, radical inverse of i), i < count.
inline Vec2f hammersley(uint32_t i, uint32_t count) {
    return {(static_cast<float>(i) + 0.5f) / static_cast<float>(count), radical_inverse(i)};
}

/// Bits of the second Sobol' dimension, lowest bit first. Its generator matrix is Pascal's triangle modulo 2, whose product
/// with i is, bit by bit, the parity of all bits of i at positions that contain the bit's own position as a binary set: a
/// transform that takes five steps instead of a loop over direction numbers.
inline uint32_t sobol_pascal(uint32_t i) {
    i ^= (i & 0xaaaaaaaau) >> 1;
    i ^= (i & 0xccccccccu) >> 2;
    i ^= (i & 0xf0f0f0f0u) >> 4;
    i ^= (i & 0xff00ff00u) >> 8;
    return i ^ (i >> 16);
}

/// Owen's nested scrambling of bits given lowest first: each bit is flipped by a hash of the seed and the bits below it.
/// Source: Laine & Karras 2011 and Burley 2020; constants by Vegdahl 2021.
inline uint32_t owen_scramble_reversed(uint32_t x, uint32_t seed) {
    x ^= x * 0x3d20adeau;
    x += seed;
    x *= (seed >> 16) | 1u;
    x ^= x * 0x05526c56u;
    return x ^ (x * 0x53a22864u);
}

/// Point `index` of the two-dimensional Sobol' sequence: every aligned run of 2^k points is a (0, k, 2)-net.
inline Vec2f sobol(uint32_t index) { return {radical_inverse(index), radical_inverse(sobol_pascal(index))}; }

/// The same, Owen-scrambled: still a net, each point uniform on the square, and sequences of different seeds independent.
/// Any seed will do, neighbouring integers included.
inline Vec2f owen_sobol(uint32_t index, uint32_t seed) {
    const uint32_t seed_x = hash_bits(seed), seed_y = hash_bits(seed_x + 0x9e3779b9u);
    return {radical_inverse(owen_scramble_reversed(index, seed_x)),
            radical_inverse(owen_scramble_reversed(sobol_pascal(index), seed_y))};
}

}  // namespace burnish
