// SPDX-License-Identifier: MIT
// A worker that writes and reads H5MD files, made when first asked for: {id, do, ...} to {id, ok, ...}.
import {readDatasets, readTrajectory} from './hdf5/h5md_read.mjs';
import {h5mdFile} from './hdf5/h5md_write.mjs';

const CALLS = {
  write: (ask) => ({bytes: h5mdFile(ask)}),
  read: ({bytes}) => readTrajectory(bytes),
  datasets: ({bytes, paths}) => readDatasets(bytes, paths),
};

self.onmessage = async ({data}) => {
  try {
    const reply = await CALLS[data.do](data);
    const arrays = reply.bytes ? [reply.bytes] : reply.frames ?? [];
    self.postMessage({id: data.id, ok: true, ...reply}, arrays.map((array) => array.buffer));
  } catch (error) {
    self.postMessage({id: data.id, ok: false, error: error.message});
  }
};
