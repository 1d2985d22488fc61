// Fills the page from the data in it.
'use strict';

(() => {
  const scenes = JSON.parse(document.getElementById('data').textContent);
  const $ = (id) => document.getElementById(id);
  const { table, bars, recall, meters, escape, percent, whole, short } = Charts;
  const css = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
  let current = 0;
  let viewer = null;

  // The figures point by point: by index where labels were scored, else against the map.
  const points = (scene) => (scene.scores.SA !== undefined ? scene.scores : scene.scores.dynamicmap) || {};

  function showCards(scene) {
    const s = points(scene);
    const cards = [
      ['Static points kept, SA', `${percent(s.SA)}<small> %</small>`],
      ['Moving points removed, DA', `${percent(s.DA)}<small> %</small>`],
      ['Both, AA', `${percent(s.AA)}<small> %</small>`],
      ['Parked vehicles kept', `${percent(s.parked_SA)}<small> %</small>`],
      ['Moving instances removed', `${s.instances_removed ?? '–'}<small> of ${s.instances ?? '–'}</small>`],
      ['Static instances removed', `${s.static_instances_removed ?? '–'}<small> of ${s.static_instances ?? '–'}</small>`]
    ];
    $('cards').innerHTML = cards.map(([k, v]) => `<div><dt>${escape(k)}</dt><dd>${v}</dd></div>`).join('');
  }

  function showProtocols(scene) {
    const { scores } = scene, rows = [];
    const add = (text, note, figures) => rows.push({ cells: [{ text, note }, ...figures.map(([label, value]) => ({ label, value }))] });
    const f1 = (value) => (value === null || value === undefined ? '–' : value.toFixed(4));
    if (scores.SA !== undefined) add('By point index', `${whole(scores.points)} points within ${scores.range_m} m, each by its own label`, [['SA', percent(scores.SA)], ['DA', percent(scores.DA)], ['AA', percent(scores.AA)]]);
    const m = scores.dynamicmap;
    if (m) add('DynamicMap', `${whole(m.points)} points within ${scores.range_m} m; kept if the map has a point within 0.05 m`, [['SA', percent(m.SA)], ['DA', percent(m.DA)], ['AA', percent(m.AA)]]);
    const e = scores.erasor;
    if (e) add('ERASOR', `${whole(e.static_voxels)} static and ${whole(e.dynamic_voxels)} dynamic voxels of 0.2 m${e.judged_only ? ', judged points only' : ''}`, [['PR', percent(e.PR)], ['RR', percent(e.RR)], ['F1', f1(e.F1)]]);
    const d = scores.draft;
    if (d) add('Draft, section IV', `${d.scans} scans every ${d.spacing_m} m, voxels of 0.05 m: TP ${whole(d.TP)}, FP ${whole(d.FP)}, TN ${whole(d.TN)}, FN ${whole(d.FN)}; ${percent(d.dynamic_rejected)} % of the dynamic points rejected`, [['R', percent(d.recall)], ['P', percent(d.precision)], ['F1', f1(d.F1)]]);
    $('protocols').innerHTML = table(['Protocol', 'Keeps', 'Rejects', 'Mean'], rows);
  }

  function showScenes() {
    $('s-scenes').hidden = scenes.length < 2;
    $('scenes').innerHTML = table(['Drive', 'Scans', 'SA', 'DA', 'AA', 'Parked SA', 'Moving removed', 'Static removed', 'PR', 'RR', 'F1'], scenes.map((scene) => {
      const s = points(scene), e = scene.scores.erasor || {};
      return { cells: [scene.scores.drive, scene.scores.scans, percent(s.SA), percent(s.DA), percent(s.AA), percent(s.parked_SA), `${s.instances_removed} of ${s.instances}`, `${s.static_instances_removed} of ${s.static_instances}`, percent(e.PR), percent(e.RR), e.F1 ? e.F1.toFixed(4) : '–'] };
    }));
  }

  const widthOf = (id) => Math.max(260, $(id).clientWidth || 520);

  function showRanges(scene) {
    const s = points(scene);
    const items = (bands) => Object.entries(bands || {}).map(([label, b]) => ({ label: label.replace('beyond ', '> '), percent: b.percent, points: b.points }));
    $('range-sa').innerHTML = bars(items(s.SA_by_range), css('--good'), widthOf('range-sa'));
    $('range-da').innerHTML = bars(items(s.DA_by_range), css('--accent'), widthOf('range-da'));
  }

  function showClasses(scene) {
    const rows = [...(points(scene).classes || [])].sort((a, b) => b.points - a.points);
    $('class-moving').innerHTML = meters(rows.filter((r) => r.moving));
    $('class-static').innerHTML = meters(rows.filter((r) => !r.moving));
  }

  function showInstances(scene) {
    const share = (i) => i.removed / i.points;
    const of = (moving) => scene.instances.filter((i) => i.moving === moving).map(share);
    $('recall').innerHTML = recall([
      { name: 'moving', colour: css('--accent'), shares: of(true) },
      { name: 'static', colour: css('--bad'), shares: of(false) }
    ], widthOf('recall'));
    const rows = [...scene.instances].sort((a, b) => (b.moving - a.moving) || (b.points - a.points));
    $('instances-box').hidden = !rows.length;
    $('instances').innerHTML = table(['Class', 'Id', 'Truth', 'Points', 'Removed'], rows.map((i) => ({
      wrong: i.moving !== (share(i) >= 0.5),
      cells: [i.class, i.id, i.moving ? 'moving' : 'static', whole(i.points), `${percent(100 * share(i), 1)} %`]
    })));
  }

  function showEvidence(scene) {
    const { columns, rows, total } = scene.evidence;
    $('s-evidence').hidden = !total;
    if (!total) return;
    $('evidence-note').textContent = `${total} instances of the run's instances.csv were judged dynamic` + (total > rows.length ? `; the largest ${rows.length} are listed.` : '.') + ' Beside each stands how much of it moves by the truth; red is a mistake.';
    const heads = columns.map((c) => c.replace(/_/g, ' '));
    $('evidence').innerHTML = table([heads[0], 'moves by truth', ...heads.slice(1)], rows.map((r) => ({
      wrong: r.moving !== null && r.moving < 50,
      cells: [r.cells[0], r.moving === null ? '–' : `${percent(r.moving, 1)} %`, ...r.cells.slice(1)]
    })));
  }

  function showMap(scene) {
    $('s-map').hidden = !scene.map;
    if (!scene.map) return;
    const d = scene.scores.draft;
    $('map').src = `data:image/png;base64,${scene.map}`;
    $('map').alt = `Map from above: ${whole(d.TP)} points right, ${whole(d.FP)} wrongly kept, ${whole(d.FN)} lost.`;
    $('map-link').href = $('map').src;
    $('map-link').download = `${scene.scores.drive}_map.png`;
  }

  function showView(scene) {
    $('view-note').textContent = scene.cloud.count ? `${whole(scene.cloud.count)} points, at most one of a kind in ${(100 * scene.cloud.voxel).toFixed(0)} cm.` : 'No point to show.';
    try {
      viewer = viewer || new MapViewer($('canvas'), $('stage-message'));
      viewer.show(scene.cloud, decodeBase64($(`cloud-${current}`).textContent), scene.trajectory);
    } catch (error) {
      $('stage-message').textContent = `The 3D view needs WebGL, which this browser does not give: ${error.message}`;
      return;
    }
    showLayers();
    showLegend();
  }

  const fateColour = (fate) => `rgb(${(document.documentElement.dataset.theme === 'dark' ? fate.dark : fate.light).join(' ')})`;

  function showLayers() {
    const layers = [...FATES.map((f) => [f.key, f.name, fateColour(f)]), ['ground', 'Ground', 'var(--muted)'], ['way', 'Way of the sensor', '#f0b429']];
    $('layers').innerHTML = layers.map(([key, name, colour]) => `<label><input type="checkbox" data-layer="${key}"${viewer.hidden.has(key) ? '' : ' checked'}><i style="background:${colour}"></i>${name}<em>${viewer.counts[key] === undefined ? '' : short(viewer.counts[key])}</em></label>`).join('');
  }

  function showLegend() {
    const chip = (colour, name) => `<span><i style="background:${colour}"></i>${escape(name)}</span>`;
    const legends = {
      fate: () => FATES.slice(0, 4).map((f) => chip(fateColour(f), f.name)).join(''),
      class: () => [...new Set(viewer.meta.classes.map((c) => c.name))].map((name) => chip(`rgb(${(CLASS_COLOURS[name] || OTHER).join(' ')})`, name)).join(''),
      instance: () => '<span>one colour for each instance of the run, grey: none</span>',
      intensity: () => '<span>blue: weak, red: strong returns</span>',
      height: () => '<span>blue: low, red: high</span>'
    };
    $('legend').innerHTML = legends[viewer.colour]();
  }

  function show(index) {
    current = index;
    const scene = scenes[index];
    $('title').textContent = scene.scores.drive;
    $('subtitle').textContent = `${scene.scores.scans} scans, scored within ${scene.scores.range_m} m${scene.scores.SA === undefined ? ', against a map' : ', point by point'}.`;
    document.title = `${scene.scores.drive} · segdf report`;
    showCards(scene);
    showProtocols(scene);
    showMap(scene);
    showRanges(scene);
    showClasses(scene);
    showInstances(scene);
    showEvidence(scene);
    showView(scene);
  }

  function setTheme(theme) {
    document.documentElement.dataset.theme = theme;
    $('theme').textContent = theme === 'dark' ? 'Light' : 'Dark';
    $('theme').setAttribute('aria-label', `Change to ${theme === 'dark' ? 'light' : 'dark'} colours`);
    if (!viewer || !viewer.points) return;
    viewer.paint();
    showLayers();
    showLegend();
    showRanges(scenes[current]);
    showInstances(scenes[current]);
  }

  setTheme(matchMedia('(prefers-color-scheme: dark)').matches ? 'dark' : 'light');
  $('theme').onclick = () => setTheme(document.documentElement.dataset.theme === 'dark' ? 'light' : 'dark');
  $('scene-pick').hidden = scenes.length < 2;
  $('scene').innerHTML = scenes.map((s, k) => `<option value="${k}">${escape(s.scores.drive)}</option>`).join('');
  $('scene').onchange = (event) => show(Number(event.target.value));
  $('colours').innerHTML = [['fate', 'Verdict'], ['class', 'Class'], ['instance', 'Instance'], ['intensity', 'Intensity'], ['height', 'Height']].map(([key, name]) => `<label><input type="radio" name="colour" value="${key}"${key === 'fate' ? ' checked' : ''}><span>${name}</span></label>`).join('');
  $('colours').onchange = (event) => { viewer.setColour(event.target.value); showLegend(); };
  $('layers').onchange = (event) => viewer.setHidden(event.target.dataset.layer, !event.target.checked);
  $('size').oninput = (event) => viewer.setSize(Number(event.target.value));
  $('from-above').onclick = () => viewer.look('above');
  $('oblique').onclick = () => viewer.look('oblique');
  $('on-road').onclick = () => viewer.look('road');
  let settling = 0;
  window.addEventListener('resize', () => {
    clearTimeout(settling);
    settling = setTimeout(() => { showRanges(scenes[current]); showInstances(scenes[current]); }, 150);
  });
  showScenes();
  show(0);
})();
