// SPDX-License-Identifier: MIT
// What "Bar by bar" says where the technique or the model has no bars to be visited one by one: why,
// and in one click something that has.
import {$, element, guarded} from './dom.mjs';

/** Every ordering makes every pull of 0.24 to 1.4 Å whole in fewer than 300 visits: test/visits.mjs. */
export const EXAMPLES = [
  {name: 'ethane.xyz', title: 'ethane, held by bonds', model: 'bonds'},
  {name: 'thesis_figure_5_2', title: 'a graph of the thesis (figure 5.2)', model: 'auto'},
];
const ORDERING = 'bfs_cycle';

async function openExample(session, {name, model}) {
  const {open} = await window.pliant;
  await open.openExample(name, model);
  await session.change({technique: ORDERING});
}

const button = (text, action) => {
  const made = element('button', text, {type: 'button'});
  made.onclick = () => guarded(action);
  return made;
};

/** Why this technique cannot be watched on this model; "" where it can. */
function reasonNot(session) {
  const {technique} = session.settings;
  const row = session.facts?.techniques.find(({name}) => name === technique);
  if (!session.model || !row) return '';
  if (!row.watched) return `${technique} places many joints at once and visits no single bars. The orderings (bfs_cycle and its kin) do.`;
  const {kind, unfit} = session.model;
  if (kind !== 'graph' && unfit[technique])
    return `${technique} does not arrive on this model: where angles are held, bars form rigid units. Held by bonds alone it does.`;
  return '';
}

export function offerExample(session) {
  const reason = reasonNot(session);
  const box = $('resolution-offer');
  box.hidden = !reason;
  if (!reason) return box.replaceChildren();
  const offers = EXAMPLES.map((row) => button(`Open ${row.title}`, () => openExample(session, row)));
  if (session.model.kind === 'graph' || !session.model.unfit[ORDERING])
    offers.unshift(button(`Take ${ORDERING}`, () => session.change({technique: ORDERING})));
  return box.replaceChildren(element('span', reason), ...offers);
}
