// SPDX-License-Identifier: MIT
// three.js without what the page never asks of it: glasses, shadows, environments, and the shaders of
// all its materials but the plain one (the page brings its own). A plugin of esbuild.
import {readFileSync} from 'node:fs';
import {join} from 'node:path';

/** In place of these modules, by the ends of their names. */
const STAND_INS = {
  'renderers/webxr/WebXRManager.js': `export class WebXRManager {
    enabled = false; isPresenting = false;
    getEnvironmentBlendMode() {} addEventListener() {} removeEventListener() {} setAnimationLoop() {}
    dispose() {}
  }`,
  'renderers/webgl/WebGLShadowMap.js': `export function WebGLShadowMap() {
    this.enabled = false; this.render = () => {};
  }`,
  'renderers/webgl/WebGLEnvironments.js': `export function WebGLEnvironments() {
    this.get = () => null; this.dispose = () => {};
  }`,
  'renderers/webgl/WebGLOutput.js': 'export class WebGLOutput {}',
  'renderers/shaders/DFGLUTData.js': 'export const getDFGLUT = () => null;',
};
/** Materials whose shaders, or whose lights, have gone. */
const GONE = /materials\/(Mesh(?!Basic)\w*|Sprite|Points|Shadow|LineDashed)Material\.js$/;
const SHADER = /three\/src\/renderers\/shaders\/Shader(Chunk|Lib)\/(\w+)\.glsl\.js$/;

/** Chunks that three puts into every program. */
const OF_THE_PROGRAM = ['colorspace_pars_fragment', 'tonemapping_pars_fragment'];

/** Names of the chunks that a shader includes, and those in turn. */
function chunksOf(shaders, name, found = new Set()) {
  for (const [, chunk] of readFileSync(join(shaders, name), 'utf8').matchAll(/#include <(\w+)>/g))
    if (!found.has(chunk)) chunksOf(shaders, `ShaderChunk/${chunk}.glsl.js`, found.add(chunk));
  return found;
}

/** Shaders without comments and indents. */
const short = (text) => text.replace(/^\s*\/\/(?!.*`).*$/gm, '').replace(/^[ \t]+/gm, '').replace(/\n{2,}/g, '\n');

/** `three`: the folder of the package. */
export function threeSlim(three) {
  const shaders = join(three, 'src/renderers/shaders');
  const kept = chunksOf(shaders, 'ShaderLib/meshbasic.glsl.js', new Set(OF_THE_PROGRAM));
  const shader = ({path}) => {
    const [, kind, name] = SHADER.exec(path);
    if (kind === 'Chunk') return kept.has(name) ? short(readFileSync(path, 'utf8')) : "export default '';";
    return name === 'meshbasic' ? short(readFileSync(path, 'utf8')) : "export const vertex = '', fragment = '';";
  };
  const setup = (build) => {
    build.onResolve({filter: /^three$/}, () => ({path: join(three, 'src/Three.js'), sideEffects: false}));
    build.onLoad({filter: SHADER}, (file) => ({contents: shader(file)}));
    for (const [name, contents] of Object.entries(STAND_INS))
      build.onLoad({filter: new RegExp(`three/src/${name}$`)}, () => ({contents}));
    build.onEnd(({metafile}) => ({errors: errors(metafile)}));
  };
  return {name: 'three-slim', setup};
}

function errors(metafile) {
  return Object.values(metafile?.outputs ?? {}).flatMap(({inputs}) => Object.entries(inputs))
    .filter(([name, {bytesInOutput}]) => GONE.test(name) && bytesInOutput > 0)
    .map(([name]) => ({text: `${name} has no shaders in the page: see apps/play/three_slim.mjs`}));
}
