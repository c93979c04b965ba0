// SPDX-License-Identifier: MIT
// Domains of an ensemble: their colours, their residues, and how far each turns about which axis.
import {$, element} from './dom.mjs';
import {domainColour} from '../view/colours.mjs';
import {endsOf, Hinges} from '../view/hinges.mjs';

const list = (words) => (words.length < 2 ? words.join('') : `${words.slice(0, -1).join(', ')} and ${words.at(-1)}`);

/** "Turns by 70° and shifts by 1.2 Å; hinges at ILE116 and ARG165". */
function turnWords({angle, shift, hinges}) {
  const parts = [`Turns by ${Math.round(angle)}°`];
  if (Math.abs(shift) >= 0.5) parts.push(`and shifts by ${Math.abs(shift).toFixed(1)} Å along the axis`);
  if (hinges.length) parts.push(`about ${hinges.length === 1 ? 'the hinge' : 'the hinges'} ${list(hinges)}`);
  return parts.join(' ');
}

export class Domains {
  constructor(stage, view, look) {
    Object.assign(this, {stage, view, look});
    this.hinges = new Hinges(view, $('stage'));
    this.count = 0;
    $('ensemble-axes').onchange = () => {
      this.hinges.isShown = $('ensemble-axes').checked;
      view.stale = true;
    };
  }

  close() {
    this.count = 0;
    this.hinges.set([], []);
  }

  /** `indexOf`: of a frame of the file among those that are held, -1 where it is not. */
  open(found, indexOf, show) {
    this.close();
    $('ensemble-domains').hidden = !found.frames;
    $('ensemble-domain-list').replaceChildren();
    $('ensemble-axes-row').hidden = !found.turns;
    $('ensemble-domains-note').textContent = found.turns ? 'Parts that move as wholes. An arrow is an axis: a domain turns about it as the fingers of a right hand whose thumb points along it.'
      : `${(found.noDomains ?? '').replace(/^./, (letter) => letter.toUpperCase())}.`;
    if (!found.turns) return;
    this.colour(found);
    this.fill(found, indexOf, show);
    this.turn(found, indexOf);
    this.stand();
  }

  /** Colours of domains on what is open now. */
  colour(found) {
    if (!found.turns) return;
    this.count = found.domainNames.length;
    Object.assign(this.stage.model, {domain: found.domain, domains: this.count});
    this.look.allow('domain', true);
    this.look.setColouring('domain');
  }

  fill({domainNames, turns}, indexOf, show) {
    const rows = domainNames.map((name, k) => {
      const row = element('li');
      const swatch = element('i', '', {'aria-hidden': 'true'});
      swatch.style.background = `rgb(${domainColour(k).join(',')})`;
      row.append(swatch, element('span', `${k + 1}: ${name}`));
      const turn = turns.find(({domain}) => domain === k);
      if (turn) row.append(this.button(turn, indexOf, show));
      return row;
    });
    $('ensemble-domain-list').replaceChildren(...rows);
  }

  /** Shows the one end of the turn, then the other. */
  button(turn, indexOf, show) {
    const made = element('button', turnWords(turn), {
      type: 'button', title: `Between frames ${turn.from} and ${turn.to}, against domain 1: click for the one, then the other`,
    });
    const ends = [turn.from, turn.to].map(indexOf).filter((index) => index >= 0);
    made.onclick = () => {
      ends.reverse();
      if (ends.length) show(ends[0]);
    };
    made.disabled = !ends.length;
    return made;
  }

  turn({domain, turns, core}, indexOf) {
    const {frames} = this.stage;
    const rows = turns.filter(({from}) => indexOf(from) >= 0).map((turn) => {
      const from = frames.at(indexOf(turn.from)).positions;
      const joints = domain.flatMap((number, joint) => (number === turn.domain ? [joint] : []));
      return {from, ends: endsOf(turn, joints, from), colour: domainColour(turn.domain), words: `${Math.round(turn.angle)}°`};
    });
    this.hinges.set(rows, core);
  }

  /** The axes go along with the first domain. */
  stand() {
    if (!this.hinges.rows.length) return;
    const {stage} = this;
    const positions = stage.at === null ? stage.session.positions : stage.frames.at(stage.at).positions;
    this.hinges.stand(positions);
    this.view.stale = true;
  }
}
