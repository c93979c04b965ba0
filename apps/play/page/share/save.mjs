// SPDX-License-Identifier: MIT
// What can be saved besides files of positions: by its name in the menu, {parts, ending, type}.
import {film, filmEnding} from './film.mjs';
import {largePicture} from './picture.mjs';
import {sdfText} from './sdf.mjs';
import {sharedPage} from './share.mjs';

async function sdf({session, stage}) {
  const isOwn = !session.live && !stage.isReplay;
  const {bondOrders, charges} = isOwn ? await session.recorded() : {};
  return sdfText(stage.model, stage.frames.list, stage.model.title || session.fileName, {orders: bondOrders, charges});
}

export const SAVES = {
  share: {make: async (parts) => [await sharedPage(parts)], ending: 'html', type: 'text/html'},
  sdf: {make: sdf, ending: 'sdf', type: 'chemical/x-mdl-sdfile'},
  large: {make: async ({view}) => [await largePicture(view)], ending: 'png', type: 'image/png'},
  video: {make: async (parts) => [await film(parts)], ending: filmEnding(), type: `video/${filmEnding()}`},
};
