// SPDX-License-Identifier: MIT
// GLSL of the view. Balls and sticks are drawn as boxes and quads in which each pixel's ray is cut
// with the exact sphere or capsule (ray-traced impostors: Sigg, Botsch & Gross, SPBG 2006). Nothing
// but textures is read: one holds the positions of all walkers, so that a frame is one upload.

export const shared = /* glsl */`
precision highp float;
precision highp int;
precision highp isampler2D;
uniform mat4 viewMatrix, projectionMatrix;
in vec3 position;
uniform highp sampler2D positions;  // x, y, z of joint j of walker w at texel w * joints + j
uniform highp sampler2D look;       // colour of a joint, radius / 4 Angstrom
uniform highp sampler2D marks;      // r: pinned, g: how lately the repair passed here
uniform int width, joints;
uniform float ballScale, unit;      // unit: length of a usual bar / 1.5 Angstrom
uniform isampler2D members;         // numbers of those that are drawn, where not all are
uniform int memberCount;            // 0: all
uniform vec4 others;                // colour of walkers after the first, and how much of it they have
vec3 ofWalker(int walker, vec3 colour) { return walker > 0 ? mix(colour, others.rgb, others.a) : colour; }
ivec2 texel(int i) { return ivec2(i % width, i / width); }
vec3 place(int walker, int joint) {
  return (viewMatrix * vec4(texelFetch(positions, texel(walker * joints + joint), 0).xyz, 1.)).xyz;
}
ivec2 member(int instance, int all) {  // number and walker
  if (memberCount == 0) return ivec2(instance % all, instance / all);
  return ivec2(texelFetch(members, texel(instance % memberCount), 0).x, instance / memberCount);
}
float ballRadius(int joint) { return texelFetch(look, texel(joint), 0).a * 4. * ballScale * unit; }
`;

export const shading = /* glsl */`
precision highp float;
precision highp int;
uniform mat4 projectionMatrix;
uniform vec3 background;
uniform vec2 fog;        // distances from the eye at which it begins and ends
uniform float picking;   // 1: write numbers, not colours
uniform float rich;      // 1: with a glint
uniform float unlit;     // 1: the colour alone; the light comes later
layout(location = 0) out vec4 pixel;
vec3 shade(vec3 colour, vec3 hit, vec3 normal) {
  if (unlit > .5) return colour;
  vec3 eye = normalize(-hit);
  float facing = max(dot(normal, eye), 0.);
  float light = .38 + .62 * pow(max(dot(normal, normalize(vec3(-.35, .55, .8))) * .5 + .5, 0.), 1.4);
  float glint = 0.;
  if (rich > .5) glint = pow(max(dot(reflect(-normalize(vec3(-.35, .55, .8)), normal), eye), 0.), 28.) * .22;
  vec3 lit = colour * light * mix(.5, 1., smoothstep(.0, .42, facing)) + glint;
  return mix(lit, background, .72 * smoothstep(fog.x, fog.y, -hit.z));
}
vec4 number(int i) {
  return vec4(float(i & 255), float((i >> 8) & 255), float((i >> 16) & 255), 255.) / 255.;
}
`;

/** Of what is cut by the ray, not drawn as triangles. */
const ownDepth = /* glsl */`
void depthOf(vec3 hit) {
  vec4 clip = projectionMatrix * vec4(hit, 1.);
  gl_FragDepth = .5 * clip.z / clip.w + .5;
}
`;

export const ballVertex = shared + /* glsl */`
uniform vec3 lit;  // joint under the pointer, near and far end of the bar in hand
uniform vec3 hoverColour, nearColour, farColour, pinColour, waveColour;
flat out vec3 centre, colour;
flat out float radius;
flat out int joint, ring;
out vec3 onQuad;
void main() {
  ivec2 which = member(gl_InstanceID, joints);
  joint = which.x;
  int walker = which.y;
  centre = place(walker, joint);
  colour = texelFetch(look, texel(joint), 0).rgb;
  radius = ballRadius(joint);
  ring = 0;
  vec2 mark = texelFetch(marks, texel(joint), 0).rg;
  colour = mix(colour, waveColour, .85 * mark.g);
  if (mark.r > .5) { ring = 1; radius = max(radius, .34 * unit) * 1.12; }
  colour = ofWalker(walker, colour);
  if (walker == 0 && joint == int(lit.x)) { colour = hoverColour; radius = max(radius, .3 * unit) * 1.15; }
  if (joint == int(lit.y)) { colour = nearColour; radius = max(radius, .3 * unit) * 1.2; }
  if (joint == int(lit.z)) { colour = farColour; radius = max(radius, .3 * unit) * 1.2; }
  if (radius <= 0.) { gl_Position = vec4(2., 2., 2., 1.); return; }
  // The quad through the sphere's horizon: what the eye sees of it lies inside.
  float distance2 = dot(centre, centre);
  float size = radius * sqrt(distance2 / max(distance2 - radius * radius, 1e-6)) * 1.06;
  vec3 forward = centre * inversesqrt(distance2);
  vec3 right = normalize(cross(forward, vec3(0., 1., .0001)));
  onQuad = centre + size * (position.x * right + position.y * cross(right, forward));
  gl_Position = projectionMatrix * vec4(onQuad, 1.);
}`;

export const ballFragment = shading + ownDepth + /* glsl */`
uniform vec3 pinColour;
flat in vec3 centre, colour;
flat in float radius;
flat in int joint, ring;
in vec3 onQuad;
void main() {
  vec3 ray = normalize(onQuad);
  float along = dot(ray, centre);
  float off = sqrt(max(dot(centre, centre) - along * along, 0.));
  float edge = max(fwidth(off), 1e-6);
  if (off > radius + .5 * edge) discard;
  vec3 hit = ray * (along - sqrt(max(radius * radius - off * off, 0.)));
  depthOf(hit);
  if (picking > .5) { pixel = number(joint + 1); return; }
  vec3 normal = (hit - centre) / radius;
  vec3 base = ring == 1 && abs(normal.y) < .38 ? pinColour : colour;
  pixel = vec4(shade(base, hit, normal), clamp((radius - off) / edge + .5, 0., 1.));
}`;

// A capsule in a box about its axis. Subclasses of stick: bars, and pieces of the trace.
const capsuleVertex = /* glsl */`
flat out vec3 from, to, colourFrom, colourTo;
flat out float radius, dashes;
flat out int bar;
out vec3 onBox;
void box() {
  vec3 axis = to - from;
  float len = length(axis);
  vec3 along = len > 1e-6 ? axis / len : vec3(0., 0., 1.);
  vec3 side = normalize(cross(along, abs(along.y) < .9 ? vec3(0., 1., 0.) : vec3(1., 0., 0.)));
  vec3 middle = .5 * (from + to);
  onBox = middle + along * position.z * (.5 * len + radius) +
          radius * (side * position.x + cross(side, along) * position.y);
  gl_Position = projectionMatrix * vec4(onBox, 1.);
}
`;

export const stickVertex = shared + capsuleVertex + /* glsl */`
uniform isampler2D bars;               // joint, joint, kind; of a contact 0xrrggbb
uniform highp sampler2D strain;        // relative deviation of a bar
uniform highp sampler2D limits;        // of a contact: least, at the start, most
uniform int barCount, firstContact;
uniform float byTautness;              // 1: contacts in the colour of how near they are to a limit
uniform float stickRadius, litBar;
uniform vec4 kindRadius;               // of bonds, other bars, contacts, all in shares of stickRadius
uniform vec3 longColour, shortColour, litColour;
vec3 tautness(vec3 l, float now) {     // TAUTNESS of colours.mjs
  float t = clamp(now > l.y ? (now - l.y) / max(l.z - l.y, 1e-3) : l.x > 0. ? (l.y - now) / max(l.y - l.x, 1e-3) : 0., 0., 1.);
  vec3 between = vec3(.94, .706, 0.);
  return t < .5 ? mix(vec3(.263, .576, .765), between, 2. * t) : mix(between, vec3(.698, .094, .169), 2. * t - 1.);
}
float shownStrain(float s) {           // 0 at 1e-4 of the length, 1 at a tenth of it
  return clamp((log(abs(s) + 1e-9) / log(10.) + 4.) / 3., 0., 1.);
}
void main() {
  ivec2 which = member(gl_InstanceID, barCount);
  bar = which.x;
  int walker = which.y;
  ivec4 b = texelFetch(bars, texel(bar), 0);
  from = place(walker, b.x);
  to = place(walker, b.y);
  float s = walker == 0 ? texelFetch(strain, texel(bar), 0).r : 0.;
  float t = shownStrain(s);
  float share = b.z == 0 ? kindRadius.x : b.z == 1 ? kindRadius.y : kindRadius.z;
  if (b.z == 1 && t > .25) share = max(share, .45);
  radius = stickRadius * unit * share * (1. + .5 * t);
  dashes = b.z == 2 ? 1. : 0.;
  colourFrom = texelFetch(look, texel(b.x), 0).rgb;
  colourTo = texelFetch(look, texel(b.y), 0).rgb;
  if (b.z == 2) colourFrom = colourTo = vec3(b.w >> 16 & 255, b.w >> 8 & 255, b.w & 255) / 255.;
  if (b.z == 2 && byTautness > .5) {
    colourFrom = colourTo = tautness(texelFetch(limits, texel(bar - firstContact), 0).xyz, distance(from, to));
    radius *= 1.6;
  }
  colourFrom = ofWalker(walker, colourFrom);
  colourTo = ofWalker(walker, colourTo);
  if (b.z == 2 && walker > 0 && others.a == 1.) radius = 0.;
  vec3 broken = s > 0. ? longColour : shortColour;
  colourFrom = mix(colourFrom, broken, t);
  colourTo = mix(colourTo, broken, t);
  if (bar == int(litBar)) { colourFrom = colourTo = litColour; radius = stickRadius * unit * 1.6; }
  if (radius <= 0.) { gl_Position = vec4(2., 2., 2., 1.); return; }
  box();
}`;

// Catmull-Rom through the CA or P of a chain, five capsules between two of them.
export const traceVertex = shared + capsuleVertex + /* glsl */`
uniform isampler2D controls;           // four joints of a piece
uniform int pieceCount;
uniform float traceRadius;
vec3 spline(vec3 a, vec3 b, vec3 c, vec3 d, float t) {
  return .5 * (2. * b + (c - a) * t + (2. * a - 5. * b + 4. * c - d) * t * t +
               (3. * b - a - 3. * c + d) * t * t * t);
}
void main() {
  int piece = (gl_InstanceID / 5) % pieceCount, part = gl_InstanceID % 5;
  int walker = gl_InstanceID / (5 * pieceCount);
  ivec4 k = texelFetch(controls, texel(piece), 0);
  vec3 a = place(walker, k.x), b = place(walker, k.y), c = place(walker, k.z), d = place(walker, k.w);
  from = spline(a, b, c, d, float(part) / 5.);
  to = spline(a, b, c, d, float(part + 1) / 5.);
  radius = traceRadius;
  dashes = 0.;
  bar = -1;
  vec3 first = ofWalker(walker, texelFetch(look, texel(k.y), 0).rgb);
  vec3 last = ofWalker(walker, texelFetch(look, texel(k.z), 0).rgb);
  colourFrom = mix(first, last, float(part) / 5.);
  colourTo = mix(first, last, float(part + 1) / 5.);
  box();
}`;

export const stickFragment = shading + ownDepth + /* glsl */`
uniform int joints;
flat in vec3 from, to, colourFrom, colourTo;
flat in float radius, dashes;
flat in int bar;
in vec3 onBox;
// The ray t * ray against the sphere at c; -1 if it misses.
float ball(vec3 ray, vec3 c) {
  float b = dot(ray, c), h = b * b - dot(c, c) + radius * radius;
  return h < 0. ? -1. : b - sqrt(h);
}
void main() {
  vec3 ray = normalize(onBox), axis = to - from;
  float aa = dot(axis, axis), ar = dot(axis, ray), ao = -dot(axis, from);
  float a = aa - ar * ar, b = aa * -dot(ray, from) - ao * ar;
  float c = aa * dot(from, from) - ao * ao - radius * radius * aa;
  float h = b * b - a * c, t = -1.;
  if (h >= 0. && a > 1e-9) t = (-b - sqrt(h)) / a;
  float share = t < 0. ? -1. : (ao + t * ar) / aa;
  if (t < 0. || share < 0. || share > 1.) {
    float one = ball(ray, from), two = ball(ray, to);
    t = one < 0. ? two : two < 0. ? one : min(one, two);
    if (t < 0.) discard;
    share = clamp((ao + t * ar) / aa, 0., 1.);
  }
  if (dashes > .5 && fract(share * floor(sqrt(aa) / .55 + .5)) > .55) discard;
  vec3 hit = ray * t;
  depthOf(hit);
  if (picking > .5) { pixel = bar < 0 ? vec4(0.) : number(joints + bar + 1); return; }
  vec3 normal = normalize(hit - from - axis * share);
  pixel = vec4(shade(share < .5 ? colourFrom : colourTo, hit, normal), 1.);
}`;
