// SPDX-License-Identifier: MIT
// WebGL 2 in the few words that the view needs. What a processor keeps of programs, textures, meshes and
// targets is made when it is first drawn with, and once more where the browser has lost it.

/** Formats of textures: of the processor, of the numbers, their type. */
const FORMATS = {
  floats: ['RGBA32F', 'RGBA', 'FLOAT'], float: ['R32F', 'RED', 'FLOAT'], ints: ['RGBA32I', 'RGBA_INTEGER', 'INT'],
  bytes: ['RGBA8', 'RGBA', 'UNSIGNED_BYTE'], pair: ['RG8', 'RG', 'UNSIGNED_BYTE'],
  depth: ['DEPTH_COMPONENT24', 'DEPTH_COMPONENT', 'UNSIGNED_INT'],
};

/** Of corners. */
const ATTRIBUTES = ['position', 'normal'];

/** Numbers for shaders, by rows: whoever changes `data` calls changed(). */
export class Texture {
  constructor(format, width, height, data = null) {
    Object.assign(this, {format, width, height, data});
    this.version = 0;
  }

  changed() {
    this.version += 1;
  }
}

/** What is drawn into in place of the screen; `samples` of a pixel, 0: one. */
export class Target {
  constructor(width, height, samples = 0) {
    Object.assign(this, {width, height, samples});
    this.picture = new Texture('bytes', width, height);
    this.depths = new Texture('depth', width, height);
  }
}

/** What is drawn: corners (three numbers each, with or without normals) and faces (`index`) so many
 * times, by a program. `isOver`: whatever lies in front; `isTwoSided`: faces that look away too;
 * `isClear`: what lies behind is seen, and drawn before. */
export class Mesh {
  constructor(shape, shader, uniforms, look = {}) {
    Object.assign(this, {shape, shader, uniforms, isVisible: true, instances: 1, ...look});
  }
}

function compiled(gl, type, source) {
  const shader = gl.createShader(type);
  gl.shaderSource(shader, `#version 300 es\n${source}`);
  gl.compileShader(shader);
  if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS))
    throw new Error(`The graphics driver refuses a shader: ${gl.getShaderInfoLog(shader)}`);
  return shader;
}

function linked(gl, {vertex, fragment}) {
  const id = gl.createProgram();
  gl.attachShader(id, compiled(gl, gl.VERTEX_SHADER, vertex));
  gl.attachShader(id, compiled(gl, gl.FRAGMENT_SHADER, fragment));
  for (const [place, name] of ATTRIBUTES.entries()) gl.bindAttribLocation(id, place, name);
  gl.linkProgram(id);
  const count = gl.getProgramParameter(id, gl.ACTIVE_UNIFORMS);
  const uniforms = Array.from({length: count}, (_, k) => gl.getActiveUniform(id, k))
    .map(({name, type}) => ({name, type, place: gl.getUniformLocation(id, name)}));
  return {id, uniforms};
}

function uploaded(gl, shape) {
  const faces = gl.createVertexArray();
  gl.bindVertexArray(faces);
  const upload = (where, data) => {
    gl.bindBuffer(where, gl.createBuffer());
    gl.bufferData(where, data, gl.STATIC_DRAW);
  };
  upload(gl.ELEMENT_ARRAY_BUFFER, shape.index);
  for (const [place, name] of ATTRIBUTES.entries()) {
    if (!shape[name]) continue;
    upload(gl.ARRAY_BUFFER, shape[name]);
    gl.enableVertexAttribArray(place);
    gl.vertexAttribPointer(place, 3, gl.FLOAT, false, 0, 0);
  }
  return faces;
}

export class Renderer {
  /** Throws Error where the browser has no WebGL 2. */
  constructor(canvas, options) {
    this.canvas = canvas;
    this.gl = canvas.getContext('webgl2', {alpha: false, ...options});
    if (!this.gl) throw new Error('This browser gives no WebGL 2, by which the picture is drawn.');
    this.calls = 0;  // of drawing, for who counts them
    this.target = null;
    this.kept = new WeakMap();
    canvas.addEventListener('webglcontextlost', (event) => event.preventDefault());
    canvas.addEventListener('webglcontextrestored', () => { this.kept = new WeakMap(); });
  }

  /** What the processor keeps of a thing. */
  of(thing, make) {
    if (!this.kept.has(thing)) this.kept.set(thing, make(thing));
    return this.kept.get(thing);
  }

  texture(texture) {
    const {gl} = this;
    const [internal, format, type] = FORMATS[texture.format].map((name) => gl[name]);
    const {width, height, data, version} = texture;
    const mine = this.of(texture, () => ({id: gl.createTexture(), version: -1}));
    gl.bindTexture(gl.TEXTURE_2D, mine.id);
    if (mine.version < 0) {
      for (const name of ['MIN', 'MAG']) gl.texParameteri(gl.TEXTURE_2D, gl[`TEXTURE_${name}_FILTER`], gl.NEAREST);
      for (const name of ['S', 'T']) gl.texParameteri(gl.TEXTURE_2D, gl[`TEXTURE_WRAP_${name}`], gl.CLAMP_TO_EDGE);
      gl.texImage2D(gl.TEXTURE_2D, 0, internal, width, height, 0, format, type, data);
    } else if (mine.version < version) {
      gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, width, height, format, type, data);
    }
    mine.version = version;
    return mine.id;
  }

  /** Buffers of a target: `into`, and `out` of which its textures are read. */
  framesOf(target) {
    const {gl} = this;
    const out = gl.createFramebuffer();
    gl.bindFramebuffer(gl.FRAMEBUFFER, out);
    const parts = [[gl.COLOR_ATTACHMENT0, target.picture], [gl.DEPTH_ATTACHMENT, target.depths]];
    for (const [place, texture] of parts)
      gl.framebufferTexture2D(gl.FRAMEBUFFER, place, gl.TEXTURE_2D, this.texture(texture), 0);
    if (!target.samples) return {into: out, out, buffers: []};
    const into = gl.createFramebuffer();
    gl.bindFramebuffer(gl.FRAMEBUFFER, into);
    const buffers = parts.map(([place, {format}]) => {
      const buffer = gl.createRenderbuffer();
      gl.bindRenderbuffer(gl.RENDERBUFFER, buffer);
      gl.renderbufferStorageMultisample(gl.RENDERBUFFER, target.samples, gl[FORMATS[format][0]], target.width, target.height);
      gl.framebufferRenderbuffer(gl.FRAMEBUFFER, place, gl.RENDERBUFFER, buffer);
      return buffer;
    });
    return {into, out, buffers};
  }

  /** What is drawn from here on goes into a target; null: on the screen. */
  into(target) {
    const {gl} = this;
    this.target = target;
    gl.bindFramebuffer(gl.FRAMEBUFFER, target && this.of(target, () => this.framesOf(target)).into);
    const {width, height} = target ?? this.canvas;
    gl.viewport(0, 0, width, height);
  }

  clear([red, green, blue], opacity = 1) {
    const {gl} = this;
    gl.clearColor(red, green, blue, opacity);
    gl.depthMask(true);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
  }

  /** Makes the textures of a target of its samples. */
  resolve(target) {
    const {gl} = this;
    const {into, out} = this.of(target, () => this.framesOf(target));
    if (into === out) return;
    gl.bindFramebuffer(gl.READ_FRAMEBUFFER, into);
    gl.bindFramebuffer(gl.DRAW_FRAMEBUFFER, out);
    const box = [0, 0, target.width, target.height];
    gl.blitFramebuffer(...box, ...box, gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT, gl.NEAREST);
  }

  /** Bytes of the picture of the target that is drawn into, RGBA. */
  bytes() {
    const {gl} = this;
    const {width, height} = this.target;
    const bytes = new Uint8Array(4 * width * height);
    gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
    return bytes;
  }

  draw(mesh) {
    const {gl} = this;
    if (!mesh.isVisible || mesh.instances < 1 || gl.isContextLost()) return;
    const program = this.of(mesh.shader, (shader) => linked(gl, shader));
    gl.useProgram(program.id);
    this.tell(program, mesh.uniforms);
    const isOn = (what, wanted) => gl[wanted ? 'enable' : 'disable'](gl[what]);
    isOn('DEPTH_TEST', !mesh.isOver);
    isOn('CULL_FACE', !mesh.isTwoSided);
    isOn('SAMPLE_ALPHA_TO_COVERAGE', mesh.isSmooth);
    isOn('BLEND', mesh.isClear);
    gl.depthMask(!mesh.isOver && !mesh.isClear);
    gl.blendFunc(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA);
    gl.bindVertexArray(this.of(mesh.shape, (shape) => uploaded(gl, shape)));
    gl.drawElementsInstanced(gl.TRIANGLES, mesh.shape.index.length, gl.UNSIGNED_INT, 0, mesh.instances);
    this.calls += 1;
  }

  /** Values of {name: {value}}: a number, a list or a Texture. */
  tell({uniforms}, values) {
    const {gl} = this;
    let unit = 0;
    for (const {name, type, place} of uniforms) {
      const {value} = values[name];
      if (type === gl.FLOAT) gl.uniform1f(place, value);
      else if (type === gl.INT) gl.uniform1i(place, value);
      else if (type === gl.FLOAT_MAT4) gl.uniformMatrix4fv(place, false, value);
      else if (value instanceof Texture) {
        gl.activeTexture(gl.TEXTURE0 + unit);
        this.texture(value);
        gl.uniform1i(place, unit++);
      } else gl[`uniform${value.length}fv`](place, value);
    }
  }

  /** Frees what the processor keeps of a texture or a target; of the rest the browser does. */
  forget(thing) {
    const {gl} = this;
    const mine = thing && this.kept.get(thing);
    if (!mine) return;
    this.kept.delete(thing);
    if (thing instanceof Texture) return gl.deleteTexture(mine.id);
    for (const frame of [mine.into, mine.out]) gl.deleteFramebuffer(frame);
    for (const buffer of mine.buffers) gl.deleteRenderbuffer(buffer);
    this.forget(thing.picture);
    this.forget(thing.depths);
  }
}
