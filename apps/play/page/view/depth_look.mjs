// SPDX-License-Identifier: MIT
// A second pass over the finished picture, by its depths: outlines where something lies well in front
// of what is beside it, shadows in what lies behind, and the surface. That is spheres of larger radius,
// shaded by the plane through the depths about each pixel: smoothed on the screen, not in space.
import {Mesh, Target} from './gl.mjs';
import {shading} from './shaders.mjs';

const vertex = /* glsl */`
in vec3 position;
out vec2 place;
void main() {
  place = .5 * position.xy + .5;
  gl_Position = vec4(position.xy, 0., 1.);
}`;

const fragment = shading + /* glsl */`
uniform sampler2D picture;
uniform highp sampler2D depths;
uniform vec2 pixelSize;    // of one pixel of the screen, in shares of the picture
uniform float unit, isSurface, slope;  // slope: half height by distance
in vec2 place;
float far(vec2 at) {       // distance along the view, Angstrom
  float depth = 2. * texture(depths, at).r - 1.;
  return projectionMatrix[3][2] / (depth + projectionMatrix[2][2]);
}
bool isGround(vec2 at) { return texture(depths, at).r >= 1.; }
// Darkness by what is in front within some pixels: x outline, y shadow.
const vec2 WAYS[8] = vec2[8](vec2(1., 0.), vec2(.7071, .7071), vec2(0., 1.), vec2(-.7071, .7071), vec2(-1., 0.),
  vec2(-.7071, -.7071), vec2(0., -1.), vec2(.7071, -.7071));
vec2 covered(float z) {
  vec2 dark = vec2(0.);
  for (int k = 0; k < 8; ++k) {
    vec2 way = WAYS[k] * pixelSize;
    float step = z - far(place + 1.2 * way), off = z - far(place + (k % 2 == 0 ? 5. : 9.) * way);
    dark.x = max(dark.x, smoothstep(.9, 2.2, step / unit));
    dark.y += smoothstep(.4, 2.5, off / unit) * (1. - smoothstep(8., 20., off / unit)) / 8.;
  }
  return dark;
}
vec3 surface(vec3 colour, float z) {
  float angstrom = 2. * slope * z * pixelSize.y;  // of a pixel
  float reach = clamp(1.5 * unit / angstrom, 2., 24.);
  vec2 tilt = vec2(0.);
  vec3 sum = colour;
  float weight = 0., colours = 1.;
  for (int ring = 1; ring <= 3; ++ring)
    for (int k = 0; k < 6; ++k) {
      float angle = 3.1415927 * (float(k) + .33 * float(ring)) / 6., off = reach * float(ring) / 3.;
      vec2 way = vec2(cos(angle), sin(angle)), step = off * way * pixelSize;
      float one = far(place + step) - z, other = far(place - step) - z;
      vec2 holds = vec2(lessThan(abs(vec2(one, other)), vec2(3. * unit)));  // 0: over an edge
      float count = holds.x + holds.y;
      if (count < .5) continue;
      tilt += way * dot(holds, vec2(one, -other)) / (count * off * angstrom);
      sum += holds.x * texture(picture, place + step).rgb + holds.y * texture(picture, place - step).rgb;
      weight += 1.;
      colours += count;
    }
  vec3 hit = vec3((2. * place - 1.) * slope * z * vec2(projectionMatrix[1][1] / projectionMatrix[0][0], 1.), -z);
  vec3 normal = weight < 1. ? vec3(1., 0., .1) : normalize(vec3(2. * tilt / weight, 1.));
  return shade(sum / colours, hit, normal);
}
void main() {
  pixel = texture(picture, place);
  bool ground = isGround(place);
  float z = far(place);
  if (isSurface > .5 && !ground) pixel.rgb = surface(pixel.rgb, z);
  if (rich < .5) return;
  vec2 dark = covered(z);
  vec3 ink = background.g > .5 ? vec3(.1) : vec3(0.);
  if (ground) { pixel = mix(pixel, vec4(ink, 1.), background.g > .5 ? .55 * dark.x : 0.); return; }
  float near = 1. - .8 * smoothstep(fog.x, fog.y, z);
  pixel.rgb = mix(pixel.rgb, ink, near * max(.55 * dark.x, .5 * dark.y));
}`;

export class DepthLook {
  /** `shared`: the uniforms of the picture; `quad`: the whole of it; samples: of each pixel. */
  constructor(shared, quad, samples) {
    this.uniforms = {
      ...shared, picture: {value: null}, depths: {value: null}, pixelSize: {value: [0, 0]}, isSurface: {value: 0},
      slope: {value: 1},
    };
    this.samples = samples;
    this.mesh = new Mesh(quad, {vertex, fragment}, this.uniforms, {isOver: true});
  }

  room(renderer) {
    const {width, height} = renderer.canvas;
    if (this.target?.width === width && this.target.height === height) return;
    renderer.forget(this.target);
    this.target = new Target(width, height, this.samples);
    this.uniforms.picture.value = this.target.picture;
    this.uniforms.depths.value = this.target.depths;
  }

  /** What `paint` draws, and what its depths tell. `ratio`: pixels of the picture by CSS pixel. */
  draw(renderer, paint, {isSurface, ratio, slope}) {
    const {width, height} = renderer.canvas;
    const {uniforms} = this;
    this.room(renderer);
    uniforms.unlit.value = Number(isSurface);
    renderer.into(this.target);
    paint();
    renderer.resolve(this.target);
    renderer.into(null);
    uniforms.unlit.value = 0;
    uniforms.pixelSize.value = [Math.max(1, ratio) / width, Math.max(1, ratio) / height];
    uniforms.isSurface.value = Number(isSurface);
    uniforms.slope.value = slope;
    renderer.draw(this.mesh);
  }
}
