// Charts as SVG, tables and meters as HTML.
'use strict';

const Charts = (() => {
  const escapes = { '&': '&amp;', '<': '&lt;', '>': '&gt;', '"': '&quot;' };
  const escape = (text) => String(text).replace(/[&<>"]/g, (c) => escapes[c]);
  const percent = (value, digits = 2) => (value === null || value === undefined ? '–' : value.toFixed(digits));
  const whole = (value) => Number(value).toLocaleString('en');

  // items: [{label, percent or null, points}]; width: of the place, pixels, so that text keeps its size
  function bars(items, colour, width) {
    if (!items.length) return '<p class="muted">No such point in this drive.</p>';
    const height = 236, left = 34, bottom = 44, top = 20;
    const inner = height - bottom - top, step = (width - left) / items.length;
    const y = (value) => top + inner * (1 - value / 100);
    let svg = `<svg viewBox="0 0 ${width} ${height}" role="img" aria-label="${escape(items.map((i) => `${i.label}: ${percent(i.percent, 1)} %`).join(', '))}">`;
    for (const tick of [0, 25, 50, 75, 100]) {
      svg += `<line class="grid" x1="${left}" x2="${width}" y1="${y(tick)}" y2="${y(tick)}"/><text x="${left - 6}" y="${y(tick) + 4}" text-anchor="end">${tick}</text>`;
    }
    items.forEach((item, k) => {
      const x = left + k * step, middle = x + step / 2, value = item.percent || 0;
      svg += `<rect x="${x + step * 0.18}" width="${step * 0.64}" y="${y(value)}" height="${Math.max(1, inner * value / 100)}" rx="3" fill="${colour}"/>`;
      svg += `<text class="value" x="${middle}" y="${y(value) - 5}" text-anchor="middle">${percent(item.percent, 1)}</text>`;
      svg += `<text x="${middle}" y="${height - 26}" text-anchor="middle" font-size="${step < 52 ? 10.5 : 12}">${escape(item.label.replace(' m', step < 60 ? '' : ' m'))}</text>`;
      svg += `<text x="${middle}" y="${height - 9}" text-anchor="middle" font-size="10.5">${short(item.points)}</text>`;
    });
    return svg + '</svg>';
  }

  function short(count) {
    if (count >= 1e6) return `${(count / 1e6).toFixed(1)} M`;
    return count >= 1e3 ? `${(count / 1e3).toFixed(1)} k` : String(count);
  }

  // curves: [{name, colour, shares: [0..1 of each instance]}]; y: share of instances with at least x removed
  function recall(curves, width) {
    const drawn = curves.filter((c) => c.shares.length);
    if (!drawn.length) return '<p class="muted">The truth of this drive names no instances.</p>';
    const height = 290, left = 34, bottom = 42, top = 14, right = 8;
    const x = (share) => left + (width - left - right) * share;
    const y = (share) => top + (height - top - bottom) * (1 - share);
    let svg = `<svg viewBox="0 0 ${width} ${height}" role="img" aria-label="Recall curves of instances">`;
    for (const tick of [0, 0.25, 0.5, 0.75, 1]) {
      svg += `<line class="grid" x1="${left}" x2="${width - right}" y1="${y(tick)}" y2="${y(tick)}"/><text x="${left - 6}" y="${y(tick) + 4}" text-anchor="end">${tick * 100}</text>`;
      svg += `<text x="${x(tick)}" y="${height - 24}" text-anchor="${tick === 1 ? 'end' : 'middle'}">${tick * 100} %</text>`;
    }
    svg += `<line class="grid" x1="${x(0.5)}" x2="${x(0.5)}" y1="${y(1)}" y2="${y(0)}" stroke-dasharray="4 4"/>`;
    svg += `<text x="${x(0.5)}" y="${height - 5}" text-anchor="middle">removed part of the instance</text>`;
    for (const curve of drawn) {
      const sorted = [...curve.shares].sort((a, b) => a - b);
      let path = `M${x(0)} ${y(1)}`;
      sorted.forEach((share, k) => {
        path += `H${x(share).toFixed(1)}V${y(1 - (k + 1) / sorted.length).toFixed(1)}`;
      });
      svg += `<path d="${path}" fill="none" stroke="${curve.colour}" stroke-width="2.5" stroke-linejoin="round"/>`;
    }
    svg += '</svg><ul class="key">';
    for (const curve of drawn) {
      const half = curve.shares.filter((s) => s >= 0.5).length;
      svg += `<li><i style="background:${curve.colour}"></i>${escape(curve.name)}: ${half} of ${curve.shares.length} removed</li>`;
    }
    return svg + '</ul>';
  }

  // rows: [{name, percent, points, moving}]
  function meters(rows) {
    if (!rows.length) return '<p class="muted">No such class in this drive.</p>';
    return rows.map((row) => `<div class="row${row.moving ? ' moving' : ''}"><span>${escape(row.name)}<small>${short(row.points)} points</small></span>` +
      `<span class="meter"><i style="width:${row.percent || 0}%"></i></span><b>${percent(row.percent)}</b></div>`).join('');
  }

  // rows: [{cells, wrong}]; the first cell is text or {text, note}, others text or {label, value}; wrong rows are mistakes
  function table(columns, rows) {
    const head = columns.map((c) => `<th scope="col">${escape(c)}</th>`).join('');
    const body = rows.map((row) => `<tr${row.wrong ? ' class="wrong"' : ''}>` + row.cells.map((cell, k) => {
      if (k > 0) return cell && cell.label ? `<td><small>${escape(cell.label)}</small>${escape(cell.value)}</td>` : `<td>${escape(cell)}</td>`;
      return cell.note ? `<th scope="row" class="wrap">${escape(cell.text)}<small>${escape(cell.note)}</small></th>` : `<th scope="row">${escape(cell)}</th>`;
    }).join('') + '</tr>').join('');
    return `<thead><tr>${head}</tr></thead><tbody>${body}</tbody>`;
  }

  return { bars, recall, meters, table, escape, percent, whole, short };
})();
