// SPDX-License-Identifier: MIT
// GLSL of the ribbon: a strip for each two residues that follow each other, bent where the atoms are.
// Catmull-Rom through the CA (averaged along strands), turned so that C=O lies in its plane
// (Carson & Bugg, J. Mol. Graphics 4, 121, 1986).
import {shading, shared} from './shaders.mjs';

export const ribbonVertex = shared + /* glsl */`
uniform isampler2D pieces;  // three texels a piece: CA before, from, to, after; their O; CA beyond, flags
uniform int sides;
uniform vec3 lit, hoverColour, waveColour;
flat out vec3 colourFrom, colourTo;
flat out ivec2 ends;        // the CA of both residues
out vec3 hit, normal;
out float along;            // 0 at the first, 1 at the second
const int HELIX = 1, STRAND = 2, NUCLEIC = 3;
// Half width and half thickness in Angstrom, and how square it is.
vec3 sizeOf(int shape) {
  return shape == HELIX ? vec3(1.3, .21, 0.) : shape == STRAND ? vec3(1.15, .19, 1.)
       : shape == NUCLEIC ? vec3(.8, .42, 0.) : vec3(.27, .27, 0.);
}
vec3 guide(vec3 ca, int oxygen, int walker, int isTurned, vec3 other) {
  if (oxygen < 0) return other;
  return normalize(place(walker, oxygen) - ca) * (isTurned == 0 ? 1. : -1.);
}
vec3 smoothed(vec3 a, vec3 b, vec3 c, int isStrand) { return isStrand == 0 ? b : .25 * (a + 2. * b + c); }
vec3 colourOf(int joint, int walker) {
  vec3 colour = texelFetch(look, texel(joint), 0).rgb;
  colour = mix(colour, waveColour, .85 * texelFetch(marks, texel(joint), 0).g);
  colour = ofWalker(walker, colour);
  return walker == 0 && joint == int(lit.x) ? hoverColour : colour;
}
// Without thickness; a tube faces the eye.
void flatStrip(vec3 middle, vec3 tangent, vec3 side, vec2 size) {
  float edge = 2. * position.y - 1., flatness = smoothstep(.1, .5, size.x - size.y);
  vec3 turned = normalize(cross(tangent, -middle));
  side = normalize(mix(turned * (dot(turned, side) < 0. ? -1. : 1.), side, flatness));
  vec3 over = cross(tangent, side);
  if (flatness < .5 && dot(over, middle) > 0.) over = -over;
  hit = middle + side * edge * size.x;
  normal = over + side * edge * (1.5 - 1.4 * flatness);
}
void roundStrip(vec3 middle, vec3 side, vec3 over, vec3 size) {
  float angle = (position.y + .5) * 6.2831853 / float(sides);
  vec2 unitary = vec2(cos(angle), sin(angle));
  float quarter = floor(angle / 1.5707963 + .5) * 1.5707963;
  vec2 corner = mix(unitary, sign(unitary), size.z) * size.xy;
  vec2 outward = mix(normalize(unitary / size.xy), vec2(cos(quarter), sin(quarter)), size.z);
  hit = middle + side * corner.x + over * corner.y;
  normal = side * outward.x + over * outward.y;
}
void main() {
  int piece = int(position.z), walker = gl_InstanceID;
  ivec4 k = texelFetch(pieces, texel(3 * piece), 0), o = texelFetch(pieces, texel(3 * piece + 1), 0);
  ivec4 more = texelFetch(pieces, texel(3 * piece + 2), 0);
  int flags = more.z;
  vec3 z = place(walker, more.x), a = place(walker, k.x), b = place(walker, k.y), c = place(walker, k.z),
       d = place(walker, k.w), e = place(walker, more.y);
  vec3 across = cross(b - a, d - c) + vec3(1e-4, 2e-4, 3e-4);  // where there is no O
  vec3 ga = guide(a, o.x, walker, flags & 1, across), gb = guide(b, o.y, walker, flags & 2, across),
       gc = guide(c, o.z, walker, flags & 4, across), gd = guide(d, o.w, walker, flags & 8, across);
  vec3 p = smoothed(z, a, b, flags & 16), q = smoothed(a, b, c, flags & 32),
       r = smoothed(b, c, d, flags & 64), s = smoothed(c, d, e, flags & 128);
  float t = position.x;
  vec3 way = r - p, bend = 2. * p - 5. * q + 4. * r - s, turn = 3. * q - p - 3. * r + s;
  vec3 middle = q + .5 * t * (way + t * (bend + t * turn));
  vec3 tangent = normalize(way + t * (2. * bend + 3. * t * turn) + 1e-6);
  vec3 side = mix(ga + 2. * gb + gc, gb + 2. * gc + gd, t);
  side = normalize(side - tangent * dot(side, tangent) + 1e-6);
  float share = smoothstep(.1, .9, t);
  vec3 size = mix(sizeOf(flags >> 8 & 3), sizeOf(flags >> 10 & 3), share);
  if ((flags & 4096) != 0) size = vec3(t > 0. ? mix(1.95, .2, t) : size.x, size.y, 1.);
  if ((flags & 8192) != 0 && t == 0. || (flags & 16384) != 0 && t == 1.) size.xy *= .05;
  if (sides == 2) flatStrip(middle, tangent, side, size.xy);
  else roundStrip(middle, side, cross(tangent, side), size);
  along = t;
  ends = k.yz;
  colourFrom = colourOf(k.y, walker);
  colourTo = colourOf(k.z, walker);
  gl_Position = projectionMatrix * vec4(hit, 1.);
}`;

export const ribbonFragment = shading + /* glsl */`
flat in vec3 colourFrom, colourTo;
uniform int sides;
flat in ivec2 ends;
in vec3 hit, normal;
in float along;
void main() {
  bool isFirst = along < .5;
  if (picking > .5) { pixel = number((isFirst ? ends.x : ends.y) + 1); return; }
  vec3 n = normalize(normal);
  if (sides == 2 && dot(n, hit) > 0.) n = -n;
  pixel = vec4(shade(isFirst ? colourFrom : colourTo, hit, n), 1.);
}`;
