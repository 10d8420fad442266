"use strict";
// The figure of a page that moves: it integrates the equations of motion that the page brings along, and draws them.
// y = (q, q', t) is the state, z = (Q, Q', t, q) the same in the coordinates of the file, p are the parameters.
const lagsolveFigure = (() => {
  const CM = 42, MARGIN = 46, TOLERANCE = 1e-10, MOST_STEPS = 1000, SVG = "http://www.w3.org/2000/svg";
  const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
  const plus = (a, b, s = 1) => [a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2]];
  const unit = a => { const s = Math.hypot(a[0], a[1], a[2]) || 1; return [a[0] / s, a[1] / s, a[2] / s]; };
  const wrapped = x => x - 2 * Math.PI * Math.ceil(x / (2 * Math.PI) - 0.5);  // between −π and π, and π itself
  const toward = (a, b) => { const s = Math.hypot(b[0] - a[0], b[1] - a[1]); return s > 1e-9 ? [(b[0] - a[0]) / s, (b[1] - a[1]) / s] : [1, 0]; };
  const beyond = (a, w, s) => [a[0] + w[0] * s, a[1] + w[1] * s];
  const far = (a, b) => Math.hypot(a[0] - b[0], a[1] - b[1]);
  const number = (x, digits = 3) => {
    if (!isFinite(x)) return "–";
    if (Math.abs(x) < 1e-12) return "0";
    const s = Math.abs(x) < 1e-3 || Math.abs(x) >= 1e5 ? x.toExponential(1).replace(/e\+?(-?)(\d+)/, (_, m, d) => "·10" + (m + d).replace(/./g, c => c == "-" ? "⁻" : "⁰¹²³⁴⁵⁶⁷⁸⁹"[c])) : String(Number(x.toPrecision(digits)));
    return s.replace(/-/g, "−");
  };

  // Linear equations: rows a[i] of length n + 1, the right side last. A row without a pivot leaves its unknown 0.
  function solved(a, n) {
    let good = true;
    const size = a.map(r => { let m = 0; for (let j = 0; j < n; j++) m = Math.max(m, Math.abs(r[j])); return m || 1; });
    const used = [];
    for (let k = 0; k < n; k++) {
      let best = -1, top = 1e-13;
      for (let i = k; i < n; i++) { const s = Math.abs(a[i][k]) / size[i]; if (s > top) { top = s; best = i; } }
      if (best < 0) { good = false; used.push(false); continue; }
      used.push(true);
      [a[k], a[best]] = [a[best], a[k]]; [size[k], size[best]] = [size[best], size[k]];
      const pivot = a[k];
      for (let i = k + 1; i < n; i++) {
        const f = a[i][k] / pivot[k];
        if (f !== 0) for (let j = k; j <= n; j++) a[i][j] -= f * pivot[j];
      }
    }
    const x = new Array(n).fill(0);
    for (let k = n - 1; k >= 0; k--) if (used[k]) {
      let s = a[k][n];
      for (let j = k + 1; j < n; j++) s -= a[k][j] * x[j];
      x[k] = s / a[k][k];
    }
    return { x, good };
  }

  // M q'' − Aᵀ λ = f, A q'' = b.
  function accelerations(v, n, m) {
    const rows = [], A = n * n + n, b = A + m * n;
    for (let i = 0; i < n; i++) {
      const r = new Array(n + m + 1);
      for (let j = 0; j < n; j++) r[j] = v[i * n + j];
      for (let j = 0; j < m; j++) r[n + j] = -v[A + j * n + i];
      r[n + m] = v[n * n + i];
      rows.push(r);
    }
    for (let i = 0; i < m; i++) {
      const r = new Array(n + m + 1).fill(0);
      for (let j = 0; j < n; j++) r[j] = v[A + i * n + j];
      r[n + m] = v[b + i];
      rows.push(r);
    }
    return solved(rows, n + m);
  }

  // The mechanics of one figure, without anything that is drawn.
  function mechanics(F, data) {
    const n = data.n, m = data.shape.con[1], finite = data.shape.con[2];
    const rate = (y, p) => {
      const a = accelerations(F.eq(y, p), data.shape.eq[0], data.shape.eq[1]);
      const d = new Array(2 * n + 1);
      for (let k = 0; k < n; k++) { d[k] = y[n + k]; d[n + k] = a.x[k]; }
      d[2 * n] = 1;
      return d;
    };
    const C = [[1 / 5], [3 / 40, 9 / 40], [44 / 45, -56 / 15, 32 / 9], [19372 / 6561, -25360 / 2187, 64448 / 6561, -212 / 729],
      [9017 / 3168, -355 / 33, 46732 / 5247, 49 / 176, -5103 / 18656], [35 / 384, 0, 500 / 1113, 125 / 192, -2187 / 6784, 11 / 84]];
    const D = [71 / 57600, 0, -71 / 16695, 71 / 1920, -17253 / 339200, 22 / 525, -1 / 40];
    let h = 0.005;
    // One step of Dormand and Prince's method, no longer than `most`; null where the equations have no solution.
    function step(y, p, most) {
      for (let tried = 0; tried < 40; tried++) {
        const last = h >= most, now = last ? most : h, k = [rate(y, p)];
        let next = y;
        for (const row of C) {
          next = y.map((s, i) => { let sum = 0; for (let j = 0; j < row.length; j++) sum += row[j] * k[j][i]; return s + now * sum; });
          k.push(rate(next, p));
        }
        let error = 0;
        for (let i = 0; i < 2 * n; i++) {
          let e = 0;
          for (let j = 0; j < 7; j++) e += D[j] * k[j][i];
          error = Math.max(error, Math.abs(now * e) / (TOLERANCE * (1 + Math.max(Math.abs(y[i]), Math.abs(next[i])))));
        }
        if (error <= 1) {
          const grown = now * Math.min(4, 0.9 * Math.pow(error + 1e-12, -0.2));
          h = last ? Math.max(h, Math.min(grown, 0.05)) : Math.min(grown, 0.05);
          return m ? projected(next, p, -1) : next;
        }
        h = now * (error > 1 ? Math.max(0.1, 0.9 * Math.pow(error, -0.2)) : 0.1);
        if (h < 1e-9) return null;
      }
      return null;
    }
    function advanced(y, p, seconds) {
      const end = y[2 * n] + seconds;
      for (let count = 0; end - y[2 * n] > 1e-12; count++) {
        if (count == MOST_STEPS) return null;
        y = step(y, p, end - y[2 * n]);
        if (y === null || y.some(x => !isFinite(x))) return null;
      }
      return y;
    }
    // The nearest state that satisfies the constraints; the coordinate `kept` does not change if that is possible.
    function projected(y, p, kept) {
      if (!m) return y;
      y = y.slice();
      for (const level of [0, 1]) for (let turn = 0; turn < 30; turn++) {
        const v = F.con(y, p), rows = [];
        for (let i = 0; i < m; i++) if (level || finite[i]) rows.push(i);
        const off = rows.map(i => v[level * m + i]);
        if (off.every(x => Math.abs(x) < 1e-14) || !rows.length) break;
        const a = rows.map(i => { const r = v.slice(3 * m + i * n, 3 * m + i * n + n); if (!level && kept >= 0) r[kept] = 0; return r; });
        const gram = a.map((r, i) => [...a.map(s => r.reduce((t, x, k) => t + x * s[k], 0)), off[i]]);
        const w = solved(gram, rows.length).x;
        let size = 0;
        for (let k = 0; k < n; k++) { const d = a.reduce((t, r, i) => t + r[k] * w[i], 0); y[level * n + k] -= d; size = Math.max(size, Math.abs(d)); }
        if (size < 1e-15) break;
      }
      return y;
    }
    function violation(y, p) {
      if (!m) return 0;
      const v = F.con(y, p);
      return Math.max(...v.slice(0, 2 * m).map(Math.abs));
    }
    const inFile = (y, p) => F.own ? F.own(y, p) : y;
    // The multipliers of the constraints of the file.
    function multipliers(y, p) {
      if (!data.bound.length) return [];
      if (data.moves) {
        const [size, count] = data.shape[F.rea ? "rea" : "eq"];
        const a = F.rea ? accelerations(F.rea(inFile(y, p), p), size, count) : accelerations(F.eq(y, p), size, count);
        return a.x.slice(size);
      }
      if (!F.sta) return [];
      const [k, size, count] = data.shape.sta, v = F.sta(y, p), Q = v.slice(k, k + size), A = i => v.slice(k + size + i * size, k + size + i * size + size);
      const rows = [...Array(count).keys()].map(A);
      return solved(rows.map(r => [...rows.map(s => r.reduce((t, x, j) => t + x * s[j], 0)), -r.reduce((t, x, j) => t + x * Q[j], 0)]), count).x;
    }
    // Applied forces, and reactions with their points: {loads: [[at, force], ...], reactions: [{value, parts}, ...]}.
    function forces(y, p) {
      const v = F.act(inFile(y, p), p), lambda = multipliers(y, p), loads = [], reactions = [];
      let at = 0;
      const three = () => { at += 3; return [v[at - 3], v[at - 2], v[at - 1]]; };
      for (const weight of data.loads) loads.push([three(), three(), weight]);
      data.bound.forEach((count, i) => {
        const parts = [], l = lambda[i] ?? NaN, factor = v[at++];
        for (let k = 0; k < count; k++) { const place = three(); parts.push([place, three().map(x => x * l)]); }
        reactions.push({ value: l * factor, lambda: l, parts });
      });
      return { loads, reactions };
    }
    // What no longer holds: "contact", "slip", "mass" or "empty"; `sense` are the senses of slips that are not given, `side` the signs of reactions at first.
    function broken(y, p, sense, side) {
      const ended = data.slips.length ? F.sli(y, p).findIndex((s, i) => data.slips[i] == 2 ? s < 1e-9 : s * (data.slips[i] || sense[i]) < -1e-9) : -1;
      if (ended >= 0) return { 3: "mass", 4: "empty" }[data.slips[ended]] || "slip";
      if (!data.guards.some(g => g && g < 4)) return "";
      const f = forces(y, p).reactions;
      return data.guards.some((g, i) => g && g < 4 && (g == 3 ? f[i].value * (side[i] || 0) : g == 2 ? f[i].value : g * f[i].lambda) < -1e-9) ? "contact" : "";
    }
    // The sense in which a slip begins that is zero; 0 where friction holds it, with the static coefficient if there is one.
    function begins(y, p, i) {
      const q = p.slice(), slip = s => F.sli(s, p)[i], e = 1e-7;
      for (const [k, x] of data.static) q[k] = Math.max(q[k], x);
      const slope = [...Array(n).keys()].map(j => { const s = y.slice(); s[n + j] += e; return (slip(s) - slip(y)) / e; });
      const size = slope.reduce((t, x) => t + x * x, 0);
      if (size > 0) for (const sense of [1, -1]) {
        const s = projected(y.map((x, j) => j >= n && j < 2 * n ? x + sense * e * slope[j - n] / size : x), p, -1), d = rate(s, q);
        if (sense * (slip(s.map((x, j) => x + e * d[j])) - slip(s)) > 1e-9 * e) return sense;
      }
      return 0;
    }
    // The state in which the slip in a plane begins, with a small speed; null where friction holds it. At v = 0 it begins
    // in a direction u if dv/dt = a u with a > 0, the friction being the largest that is possible at rest.
    function slides(y, p) {
      const q = p.slice(), slip = s => F.pla(s, p), still = s => s.map((x, j) => j >= n && j < 2 * n ? 0 : x), add = (s, d, f) => s.map((x, j) => j >= n && j < 2 * n ? x + f * d[j - n] : x);
      for (const [k, x] of data.static) q[k] = Math.max(q[k], x);
      const rest = projected(still(y), p, -1), at = slip(rest);
      const free = [...Array(n).keys()].map(j => { const s = projected(rest.map((x, i) => i == n + j ? x + 1 : x), p, -1); return { change: s.slice(n, 2 * n).map((x, i) => x - rest[n + i]), slip: slip(s).map((x, i) => x - at[i]) }; });
      const basis = [];
      for (const turn of [0, 1]) {
        const left = free.map(f => basis.reduce((w, u) => plus(w, u, -dot(w, u)), f.slip)), size = left.map(w => Math.hypot(...w)), top = Math.max(...size);
        if (top > 1e-9) basis.push(unit(left[size.indexOf(top)]));
      }
      const B = basis.map(u => free.map(f => dot(u, f.slip)));
      const lift = c => { const w = solved(B.map((r, i) => [...B.map(s => r.reduce((t, x, k) => t + x * s[k], 0)), c[i]]), B.length).x; const f = free.map((_, j) => B.reduce((t, r, i) => t + r[j] * w[i], 0)); return rest.slice(n, 2 * n).map((_, k) => free.reduce((t, g, j) => t + g.change[k] * f[j], 0)); };
      const zero = add(rest, lift(basis.map(u => dot(u, at))), -1);
      const begun = (a, speed) => add(zero, lift([Math.cos(a), Math.sin(a)].slice(0, basis.length)), speed);
      // The acceleration of the slip along its direction, and across it.
      const grows = a => {
        const s = begun(a, 1e-8), d = rate(s, q), h = 1e-6, w = slip(s.map((x, j) => x + h * d[j])), v = slip(s), g = basis.map(u => (dot(u, w) - dot(u, v)) / h);
        return [Math.cos(a) * g[0] + Math.sin(a) * (g[1] || 0), Math.cos(a) * (g[1] || 0) - Math.sin(a) * g[0]];
      };
      const angles = basis.length == 1 ? [0, Math.PI] : [];
      if (basis.length == 2) for (let k = 0; k < 24; k++) {
        let low = k * Math.PI / 12, high = low + Math.PI / 12;
        const sign = grows(low)[1] > 0;
        if (sign == grows(high)[1] > 0) continue;
        for (let turn = 0; turn < 40; turn++) { const mid = (low + high) / 2; if (grows(mid)[1] > 0 == sign) low = mid; else high = mid; }
        angles.push(low);
      }
      const found = angles.map(a => [grows(a)[0], a]).sort((a, b) => b[0] - a[0])[0];
      return found && found[0] > 1e-7 ? begun(found[1], 1e-4) : null;
    }
    // After the end of slip i: the state in which it begins again, and its sense; null where friction holds it, or the
    // file says nothing of the other sense.
    function slipsAgain(y, p, i) {
      if (data.slips[i] == 2) { const state = F.pla ? slides(y, p) : null; return state && { state, sense: 1 }; }
      if (data.slips[i]) return null;
      const slip = s => F.sli(s, p)[i], sense = begins(y, p, i), now = slip(y);
      const slope = [...Array(n).keys()].map(j => slip(y.map((x, k) => k == n + j ? x + 1 : x)) - now), size = slope.reduce((t, x) => t + x * x, 0);
      return sense ? { sense, state: projected(y.map((x, j) => j >= n && j < 2 * n ? x + (sense * 1e-7 - now) * slope[j - n] / size : x), p, -1) } : null;
    }
    return { rate, advanced, projected, violation, inFile, forces, broken, begins, slipsAgain };
  }

  return (place, F) => {
    const root = document.querySelector(`[data-moving="${place}"]`);
    const data = JSON.parse(root.querySelector("script[type='application/json']").textContent);
    const M = mechanics(F, data), n = data.n;
    const one = s => root.querySelector(s), all = s => [...root.querySelectorAll(s)];
    const stage = one("svg.stage"), lines = one("g.lines"), texts = all("g.labels text");
    const calm = matchMedia("(prefers-reduced-motion: reduce)");
    // The state at t = 0. For other parameters, what the file says of it in its own coordinates or in these is put in again.
    function begin() {
      const s = data.y.slice();
      if (p.every((x, k) => x === data.p[k]) && M.violation(s, p) < 1e-9) return s;
      const stated = F.ini(p), given = stated.slice(data.begins.length);
      data.begins.forEach((k, i) => { s[k] = stated[i]; });
      if (data.wanted.length) for (const level of [0, 1]) for (let turn = 0; turn < 25; turn++) {
        const list = data.wanted.map((k, i) => [k, given[i]]).filter(([k]) => (k >= data.sizes) == Boolean(level));
        const z = M.inFile(s, p), off = list.map(([k, v]) => z[k] - v);
        if (!list.length || off.every(x => Math.abs(x) < 1e-13)) break;
        const columns = [...Array(n).keys()].map(j => { const a = s.slice(), e = 1e-6; a[level * n + j] += e; const w = M.inFile(a, p); return list.map(([k]) => (w[k] - z[k]) / e); });
        const w = solved(off.map((_, i) => [...off.map((_, j) => columns.reduce((t, c) => t + c[i] * c[j], 0)), off[i]]), off.length).x;
        for (let j = 0; j < n; j++) s[level * n + j] -= columns[j].reduce((t, x, i) => t + x * w[i], 0);
      }
      return M.projected(s.every(isFinite) ? s : data.y.slice(), p, -1);
    }
    let p = data.p.slice(), y = begin(), touched = false, playing = false, speed = 1, message = "", remark = "";
    let sense = [], side = [], fastest = [];
    let history = [], preview = [], reference = null, worst = 0, wrong = 0, shownAt = -1;
    let width = 600, height = 380, scale = 100, centre = [0, 0], force = 1, trace = [];

    // ---- State

    const moving = data.moves === 1;
    function integrals(s) {
      const v = F.ene(s, p);
      return { T: v[0], V: v[1], I: v.slice(2) };
    }
    function restart() {
      const e = integrals(y);
      reference = { ...e, size: Math.max(Math.abs(e.T), Math.abs(e.T + e.V), Math.abs(e.I[energy] ?? 0), 1e-12) };
      sense = data.slips.length ? F.sli(y, p).map((s, i) => Math.abs(s) > 1e-12 || data.slips[i] ? Math.sign(s) : M.begins(y, p, i)) : [];
      side = data.guards.some(g => g > 2) ? M.forces(y, p).reactions.map(f => Math.sign(f.value)) : [];
      worst = 0; wrong = M.violation(y, p); history = []; trace = []; message = remark = ""; fastest = [];
      record();
    }
    const energy = data.conserved.indexOf(1);
    // A motion that was computed before: its rows are what the page has recorded, and the reader is at its beginning.
    function remember() {
      for (const row of data.motion.slice(1)) { y = row; record(); }
      if (data.motion.length) { y = data.y.slice(); shownAt = 0; trace = trace.slice(0, 1); }
    }
    // Goes on in what is recorded, integrating between two records.
    function follow(seconds) {
      const now = y[2 * n] + seconds;
      while (shownAt + 1 < history.length && history[shownAt + 1].y[2 * n] <= now) shownAt++;
      y = history[shownAt].y.slice();
      if (shownAt + 1 == history.length) shownAt = -1; else y = M.advanced(y, p, now - y[2 * n]) ?? y;
      leave();
      return true;
    }
    function leave() {
      const z = cells(y);
      trace.push(data.points.map(k => three(z, k)));
      if (trace.length > 900) trace.shift();
    }
    function record() {
      const e = integrals(y);
      reference.size = Math.max(reference.size, Math.abs(e.T));
      if (energy >= 0) worst = Math.max(worst, Math.abs(e.I[energy] - reference.I[energy]) / reference.size);
      wrong = Math.max(wrong, M.violation(y, p));
      const r = data.bound.length ? M.forces(y, p).reactions.map(f => f.value) : [];
      if (!remark && data.guards.some((g, i) => g == 4 && r[i] * side[i] < -1e-9))
        remark = `Before t = ${number(y[2 * n], 4)} s a reaction has changed its sign: an equation acts on both sides. Written with ≥ or ≤, contact ends there.`;
      history.push({ y: y.slice(), r });
      if (history.length > 6000) history.splice(0, 1500);
      if (data.slips.length) F.sli(y, p).forEach((s, i) => { fastest[i] = Math.max(fastest[i] || 0, Math.abs(s)); });
      leave();
    }
    const fails = s => M.broken(s, p, sense, side), held = () => sense.some((s, i) => !s && !data.slips[i]);
    const endings = {
      contact: "contact is lost, or a string goes slack. From here on other equations hold.",
      slip: "the slip ends. From here on other equations hold.",
      held: "the slip ends, and friction holds it.",
      mass: "mass no longer joins or leaves. From here on other equations hold.",
      empty: "no mass is left.",
    };
    function run(seconds, piece = 1 / 60) {
      if (!moving) return true;
      if (held()) { message = "Friction holds what is at rest here."; return false; }
      const end = y[2 * n] + seconds;
      let turns = 0;
      while (end - y[2 * n] > 1e-9) {
        const part = Math.min(piece, end - y[2 * n]);
        const next = M.advanced(y, p, part);
        // Where friction would change its sense to and fro, no step is short enough.
        const sticks = next === null && data.slips.length && (fails(y) == "slip" || F.sli(y, p).some((s, i) => data.slips[i] < 3 && Math.abs(s) < 0.1 * (fastest[i] || 0)));
        if (next === null && !sticks) { message = "The motion ends here: the accelerations are no longer determined."; return false; }
        let ending = sticks ? "slip" : fails(next);
        if (ending) {
          let low = 0, high = part, at = y;
          for (let k = 0; k < 30 && !fails(y); k++) {
            const mid = (low + high) / 2, tried = M.advanced(y, p, mid);
            if (tried === null || fails(tried)) high = mid; else { low = mid; at = tried; }
          }
          y = at; record();
          const slow = ending == "slip" ? F.sli(y, p).map((s, i) => data.slips[i] > 2 ? Infinity : data.slips[i] == 2 ? Math.sqrt(s) : Math.abs(s)) : [], i = slow.indexOf(Math.min(...slow));
          let again = ending == "slip" && turns++ < 50 ? M.slipsAgain(y, p, i) : null;
          if (again && !again.state.every(isFinite)) again = null;
          if (again) { y = again.state; sense[i] = again.sense; continue; }
          if (ending == "slip" && data.slips[i] != 1 && data.slips[i] != -1 && turns < 50) ending = "held";
          message = `The motion ends at t = ${number(y[2 * n], 4)} s: ${endings[ending]}`;
          return false;
        }
        y = next; record();
      }
      return true;
    }

    // ---- From space to the page

    const cells = s => F.fig ? F.fig(M.inFile(s, p), p) : [];
    const three = (v, k) => [v[k], v[k + 1], v[k + 2]];
    const flat = v => { const u = data.units; return [v[0] * u[0][0] + v[1] * u[1][0] + v[2] * u[2][0], v[0] * u[0][1] + v[1] * u[1][1] + v[2] * u[2][1]]; };
    const page = v => { const f = flat(v); return [width / 2 + (f[0] - centre[0]) * scale, height / 2 - (f[1] - centre[1]) * scale]; };
    const way = v => { const f = flat(v); return [f[0], -f[1]]; };
    const reader = (() => { const u = data.units; return unit(cross(u.map(x => x[0]), u.map(x => x[1]))); })();
    const around = axis => { const a = unit(axis), i = [0, 1, 2].reduce((b, k) => Math.abs(a[k]) < Math.abs(a[b]) ? k : b, 0), e = [0, 0, 0]; e[i] = 1; const u = unit(cross(e, a)); return [u, cross(a, u)]; };

    function extent(v, box) {
      const add = (q, r = 0) => { const f = flat(q); if (f.every(isFinite)) { box[0] = Math.min(box[0], f[0] - r); box[1] = Math.max(box[1], f[0] + r); box[2] = Math.min(box[2], f[1] - r); box[3] = Math.max(box[3], f[1] + r); } };
      for (const e of data.items) {
        if (e.k == "corner") add(three(v, e.p[0]));
        else if (e.k == "gravity" || e.k == "spoke" || e.far) continue;
        else if (e.k == "tool") add(three(v, e.p));
        else if (e.k == "box") add(three(v, e.p), Math.max(v[e.w[0]], v[e.w[1]]) / 2);
        else if (e.k == "cone") { add(three(v, e.p), v[e.h] * 0.75); }
        else if (e.k == "string") e.p.forEach(x => Array.isArray(x) ? add(three(v, x[0]), Math.abs(v[x[1]])) : add(three(v, x)));
        else if (e.k == "curve" || e.k == "surface") sampled(e, v, 8).flat().forEach(q => add(q));
        else if (Array.isArray(e.p)) e.p.forEach(x => add(three(v, x)));
        else if (e.p !== undefined) add(three(v, e.p), e.r !== undefined && (e.k == "disc" || e.k == "sphere" || e.k == "round") ? Math.abs(v[e.r]) : 0);
      }
      if (data.axes) add([0, 0, 0]);
      return box;
    }
    // A scale at which the system fits now and, within reason, for the next seconds.
    function fit() {
      const W = stage.clientWidth || 600;
      width = Math.max(280, W); height = Math.round(Math.min(440, Math.max(270, width * 0.62)));
      stage.setAttribute("viewBox", `0 0 ${width} ${height}`);
      stage.style.height = height + "px";
      const box = extent(cells(y), [Infinity, -Infinity, Infinity, -Infinity]);
      if (!isFinite(box[0])) return;
      const w = box[1] - box[0], h = box[3] - box[2], reach = 0.9 * Math.max(w, h, 0.5);
      const most = [box[0] - reach, box[1] + reach, box[2] - reach, box[3] + reach];
      let strongest = forceSizes(y);
      preview = [];
      if (moving) {
        let s = y; const start = performance.now();
        for (let k = 0; k < 160 && performance.now() - start < 120; k++) {
          s = M.advanced(s, p, 0.05);
          if (s === null || fails(s) || held()) break;
          preview.push({ y: s, r: data.bound.length ? M.forces(s, p).reactions.map(f => f.value) : [] });
          const v = cells(s), b = [Infinity, -Infinity, Infinity, -Infinity];
          data.points.forEach(c => { const f = flat(three(v, c)); b[0] = Math.min(b[0], f[0]); b[1] = Math.max(b[1], f[0]); b[2] = Math.min(b[2], f[1]); b[3] = Math.max(b[3], f[1]); });
          if (isFinite(b[0])) { box[0] = Math.max(most[0], Math.min(box[0], b[0])); box[1] = Math.min(most[1], Math.max(box[1], b[1])); box[2] = Math.max(most[2], Math.min(box[2], b[2])); box[3] = Math.min(most[3], Math.max(box[3], b[3])); }
          if (k % 4 == 0) strongest = Math.max(strongest, forceSizes(s));
        }
      }
      const ww = Math.max(box[1] - box[0], 1e-6), hh = Math.max(box[3] - box[2], 1e-6);
      scale = Math.min((width - 2 * MARGIN) / ww, (height - 2 * MARGIN) / hh, 4 * CM / Math.max(Math.max(ww, hh) / 4, 0.2));
      centre = [(box[0] + box[1]) / 2, (box[2] + box[3]) / 2];
      force = strongest > 0 ? 1.7 * CM / strongest : 1;
    }
    function forceSizes(s) {
      const f = M.forces(s, p), sizes = [...f.loads, ...f.reactions.flatMap(r => r.parts)].map(x => Math.hypot(...flat(x[1])));
      return Math.max(0, ...sizes.filter(isFinite));
    }

    // ---- Drawing: `out` collects paths, those with a depth first

    let out = [], labels = [], edges = [];
    const tenth = x => Math.round(10 * x) / 10;
    const path = (points, closed) => "M" + points.map(q => `${tenth(q[0])} ${tenth(q[1])}`).join("L") + (closed ? "Z" : "");
    const draw = (cls, points, closed = false, depth = null) => {
      if (!points.every(q => isFinite(q[0]) && isFinite(q[1]))) return;
      out.push([cls, path(points, closed), depth]);
      if (!/^(face|grid|trail|virtual|possible)/.test(cls)) edges.push(points);
    };
    // Whether a line from a to b meets a box [left, right, top, bottom].
    function crosses(a, b, box) {
      let from = 0, to = 1;
      for (let i = 0; i < 2; i++) {
        const d = b[i] - a[i], low = box[2 * i] - a[i], high = box[2 * i + 1] - a[i];
        if (d === 0) { if (low > 0 || high < 0) return false; continue; }
        const u = d > 0 ? low / d : high / d, v = d > 0 ? high / d : low / d;
        if (u > from) from = u;
        if (v < to) to = v;
        if (from > to) return false;
      }
      return true;
    }
    const overlap = (a, b) => a[0] < b[1] && b[0] < a[1] && a[2] < b[3] && b[2] < a[3];
    function framed(points) {
      const box = [Infinity, -Infinity, Infinity, -Infinity];
      for (const [x, y] of points) { if (x < box[0]) box[0] = x; if (x > box[1]) box[1] = x; if (y < box[2]) box[2] = y; if (y > box[3]) box[3] = y; }
      return box;
    }
    // How many lines a box meets; three count as more.
    function met(box, bounds) {
      let count = 0;
      for (let e = 0; e < edges.length && count < 3; e++) {
        if (!overlap(box, bounds[e])) continue;
        const points = edges[e];
        for (let j = 1; j < points.length; j++) if (crosses(points[j - 1], points[j], box)) { count++; break; }
      }
      return count;
    }
    const label = (k, at, w, clear = 0) => { if (k >= 0) labels.push([k, at, w, clear]); };
    function arrow(cls, a, b, tip = 8.4) {
      if (far(a, b) < 2) return;
      const w = toward(a, b), s = [-w[1], w[0]], t = Math.min(tip, 0.6 * far(a, b));
      draw(cls, [a, beyond(b, w, -0.7 * t)]);
      draw(cls + " tip", [b, beyond(beyond(b, w, -t), s, 0.34 * t), beyond(beyond(b, w, -t), s, -0.34 * t)], true);
    }
    function arc(points) {
      draw("angle", points.slice(0, -1));
      const end = points[points.length - 1], before = [...points].reverse().find(q => far(q, end) > 7) || points[0];
      if (far(before, end) > 3) { const w = toward(before, end), s = [-w[1], w[0]], back = beyond(end, w, -8); draw("angle tip", [end, beyond(back, s, 2.8), beyond(back, s, -2.8)], true); }
    }
    function ground(points) {
      draw("ground", points);
      const strokes = [];
      let start = 3;
      for (let i = 0; i + 1 < points.length; i++) {
        const a = points[i], w = toward(a, points[i + 1]), size = far(a, points[i + 1]), right = [-w[1], w[0]];
        for (; start <= size; start += 6) { const foot = beyond(a, w, start); strokes.push(path([foot, beyond(beyond(foot, right, 5.5), w, -4.6)])); }
        start -= size;
        edges.push([beyond(a, right, 5.5), beyond(points[i + 1], right, 5.5)]);
      }
      if (strokes.length && strokes.length < 4000) out.push(["hatch", strokes.join(""), null]);
    }
    function spring(a, b) {
      const w = toward(a, b), s = [-w[1], w[0]], size = far(a, b), lead = Math.min(10, size / 5), turns = 10, d = (size - 2 * lead) / turns, points = [a, beyond(a, w, lead)];
      for (let k = 0; k < turns; k++) points.push(beyond(beyond(a, w, lead + (k + 0.5) * d), s, k % 2 ? 5 : -5));
      draw("spring", [...points, beyond(a, w, size - lead), b]);
    }
    function damper(a, b) {
      const w = toward(a, b), s = [-w[1], w[0]], size = far(a, b), cup = beyond(a, w, size * 0.42), piston = beyond(a, w, size * 0.52), end = beyond(a, w, size * 0.62);
      draw("damper", [a, cup]); draw("damper", [beyond(end, s, 6), beyond(cup, s, 6), beyond(cup, s, -6), beyond(end, s, -6)]);
      draw("damper", [beyond(piston, s, 4), beyond(piston, s, -4)]); draw("damper", [piston, b]);
    }
    const circle = (c, r) => [...Array(49).keys()].map(k => beyond(c, [Math.cos(k * Math.PI / 24), Math.sin(k * Math.PI / 24)], r));
    const ring = (c, axis, r) => { const [u, v] = around(axis); return [...Array(49).keys()].map(k => plus(plus(c, u, r * Math.cos(k * Math.PI / 24)), v, r * Math.sin(k * Math.PI / 24))); };
    function hull(points) {
      const o = [...points].sort((a, b) => a[0] - b[0] || a[1] - b[1]);
      const chain = list => { const kept = []; for (const q of list) { while (kept.length > 1 && (kept.at(-1)[0] - kept.at(-2)[0]) * (q[1] - kept.at(-2)[1]) - (kept.at(-1)[1] - kept.at(-2)[1]) * (q[0] - kept.at(-2)[0]) <= 0) kept.pop(); kept.push(q); } return kept.slice(0, -1); };
      return [...chain(o), ...chain(o.reverse())];
    }
    function sampled(e, v, pieces) {
      const z = M.inFile(y, p), between = (k, a, b) => v[a] + (v[b] - v[a]) * k / pieces, f = F["cur" + e.f];
      const steps = [...Array(pieces + 1).keys()];
      if (e.k == "surface") return steps.map(i => steps.map(j => f(z, p, [between(i, e.b[0], e.b[1]), between(j, e.b[2], e.b[3])])));
      return [steps.map(i => f(z, p, [between(i, e.b[0], e.b[1])]))];
    }
    function surface(grid) {
      const light = unit(plus(reader, [0.2, -0.5, 0.9])), rows = grid.length - 1, columns = grid[0].length - 1;
      for (let i = 0; i < rows; i++) for (let j = 0; j < columns; j++) {
        const c = [grid[i][j], grid[i + 1][j], grid[i + 1][j + 1], grid[i][j + 1]];
        const normal = cross(plus(c[2], c[0], -1), plus(c[3], c[1], -1));
        const bright = Math.abs(dot(unit(normal), light)), shade = bright > 0.75 ? 2 : bright > 0.4 ? 3 : 4;
        draw(`face s${shade}`, c.map(page), true, c.reduce((s, q) => s + dot(q, reader), 0) / 4 - 1e3);
      }
      for (const edge of [grid.map(r => r[0]), grid.map(r => r.at(-1)), grid[0], grid.at(-1)]) {
        const q = edge.map(page);
        if (q.some(x => far(x, q[0]) > 3)) draw("curve", q);
      }
      for (const k of [1, 2, 3]) { draw("grid", grid[Math.round(rows * k / 4)].map(page)); draw("grid", grid.map(r => page(r[Math.round(columns * k / 4)]))); }
    }
    // The curve f = 0 on which a constraint keeps a particle, from the particle in both senses.
    function traced(e) {
      const own = data.traced[e.f], z0 = M.inFile(y, p).slice(), f = F["tra" + e.f], chains = [];
      let closed = false;
      for (const sense of [1, -1]) {
        const z = z0.slice(), points = [];
        for (let k = 0; k < 700; k++) {
          let v = f(z, p);
          for (let i = 0; i < 4; i++) {
            const g = v[1] * v[1] + v[2] * v[2];
            if (!(g > 1e-18)) return null;
            z[own[0]] -= v[0] * v[1] / g; z[own[1]] -= v[0] * v[2] / g;
            v = f(z, p);
          }
          const at = page(three(v, 3));
          if (!at.every(isFinite)) break;
          points.push(at);
          if (at[0] < -20 || at[0] > width + 20 || at[1] < -20 || at[1] > height + 20) break;
          if (k > 8 && far(at, points[0]) < 3) { closed = true; break; }
          const w = [-v[2] * sense, v[1] * sense], a = flat(three(v, 6)), b = flat(three(v, 9));
          const speed = Math.hypot(w[0] * a[0] + w[1] * b[0], w[0] * a[1] + w[1] * b[1]) * scale;
          if (!(speed > 1e-12)) break;
          z[own[0]] += 4 * w[0] / speed; z[own[1]] += 4 * w[1] / speed;
        }
        chains.push(points);
        if (closed) break;
      }
      return closed ? chains[0] : [...chains[1].reverse(), ...chains[0].slice(1)];
    }
    // Where a string touches a circle on its way to a point, on the side away from the middle of its neighbours.
    function bend(c, r, before, after) {
      const middle = [(before[0] + after[0]) / 2, (before[1] + after[1]) / 2], away = toward(middle, c), turns = [];
      for (const q of [before, after]) {
        const d = far(c, q), w = toward(c, q), lean = d > r ? Math.acos(r / d) : 0, base = Math.atan2(w[1], w[0]);
        const side = [q[0] - middle[0], q[1] - middle[1]], size = Math.hypot(...side) || 1;
        const outside = t => Math.cos(t) * (0.5 * away[0] + side[0] / size) + Math.sin(t) * (0.5 * away[1] + side[1] / size);
        turns.push([base + lean, base - lean].sort((a, b) => outside(b) - outside(a))[0]);
      }
      const top = Math.atan2(away[1], away[0]), first = top + wrapped(turns[0] - top), last = top + wrapped(turns[1] - top);
      return [...Array(25).keys()].map(k => first + (last - first) * k / 24).map(t => beyond(c, [Math.cos(t), Math.sin(t)], r));
    }
    const changed = (k, value) => { const s = y.slice(); s[k] = value; return cells(s); };

    const kinds = {
      line: (e, v) => { const q = e.p.map(k => page(three(v, k))); draw(e.c, q); if (q.length == 2 && e.l >= 0) { const s = toward(q[0], q[1]); label(e.l, beyond(q[0], s, far(q[0], q[1]) / 2), [-s[1], s[0]]); } },
      face: (e, v) => draw(`${e.c} s${e.s}`, e.p.map(k => page(three(v, k))), true, 0),
      ground: (e, v) => ground(e.p.map(k => page(three(v, k)))),
      string: (e, v) => {
        const rough = e.p.map(x => page(three(v, Array.isArray(x) ? x[0] : x)));
        draw("string", e.p.flatMap((x, i) => Array.isArray(x) ? bend(rough[i], Math.abs(v[x[1]]) * scale, rough[Math.max(i - 1, 0)], rough[Math.min(i + 1, rough.length - 1)]) : [rough[i]]));
      },
      spring: (e, v) => link(e, v, spring),
      damper: (e, v) => link(e, v, damper),
      dot: (e, v) => { const q = page(three(v, e.p)); draw(e.o ? "hinge" : "particle", circle(q, e.r * CM), true); if (e.l !== undefined) label(e.l, q, [e.d[0], -e.d[1]], e.r * CM); },
      wall: (e, v) => { const w = [e.d[0], -e.d[1]], s = [-w[1], w[0]], at = beyond(page(three(v, e.p)), w, -2.5); ground([beyond(at, s, -15), beyond(at, s, 15)]); },
      round: (e, v) => { const c = circle(page(three(v, e.p)), v[e.r] * scale); ground(e.x ? c : c.reverse()); },
      disc: (e, v) => {
        const c = three(v, e.p), r = Math.abs(v[e.r]) * (e.f || 1);
        const q = e.a < 0 || data.planar ? circle(page(c), r * scale) : ring(c, three(v, e.a), r).map(page);
        draw(e.s ? `${e.c} s${e.s}` : e.c, q, true, e.s ? dot(c, reader) + (e.f ? 1e-6 : 0) : null);
      },
      sphere: (e, v) => {
        const c = three(v, e.p), r = Math.abs(v[e.r]);
        draw("body s2", circle(page(c), r * scale), true, data.planar ? 0 : dot(c, reader));
        if (!data.planar) { const up = Math.abs(data.units[2][1]) > 0.5 ? [0, 0, 1] : [0, 1, 0]; halves(ring(c, up, r), c); }
      },
      cone: (e, v) => {
        const a = unit(three(v, e.a)), tip = plus(three(v, e.p), a, -0.75 * v[e.h]), base = plus(tip, a, v[e.h]);
        if (data.planar) { const s = unit(cross([0, 0, 1], a)); draw("body s2", [tip, plus(base, s, v[e.r]), plus(base, s, -v[e.r])].map(page), true, 0); return; }
        const rim = ring(base, a, v[e.r]).map(page);
        draw("body s2", hull([page(tip), ...rim]), true, dot(tip, reader)); draw("body s3", rim, true, dot(base, reader) + 1e-3);
      },
      box: (e, v) => {
        let a = unit(three(v, e.a)), b = unit(three(v, e.b)); const c = three(v, e.p);
        if (e.x) b = data.planar ? cross([0, 0, 1], a) : around(a)[0];
        draw("body s2", [[1, 1], [-1, 1], [-1, -1], [1, -1]].map(([s, r]) => page(plus(plus(c, a, s * v[e.w[0]] / 2), b, r * v[e.w[1]] / 2))), true, data.planar ? 0 : dot(c, reader));
      },
      capsule: (e, v) => {
        const [a, b] = e.p.map(k => page(three(v, k)));
        if (!data.planar) { draw("rod", [a, b]); return; }
        const t = Math.atan2(b[1] - a[1], b[0] - a[0]), half = (c, s) => [...Array(13).keys()].map(k => beyond(c, [Math.cos(t + s + k * Math.PI / 12), Math.sin(t + s + k * Math.PI / 12)], e.w * CM));
        draw("body s2", [...half(b, -Math.PI / 2), ...half(a, Math.PI / 2)], true, 0);
      },
      oval: (e, v) => {
        const c = page(three(v, e.p)), w = toward([0, 0], way(three(v, e.v))), s = [-w[1], w[0]];
        draw("body s2", [...Array(49).keys()].map(k => beyond(beyond(c, w, 26 * Math.cos(k * Math.PI / 24)), s, 15 * Math.sin(k * Math.PI / 24))), true, 0);
        draw("reference", [c, beyond(c, w, 26)]);
      },
      spoke: (e, v) => { const c = three(v, e.p); draw("reference", [page(c), page(plus(c, unit(three(v, e.v)), Math.abs(v[e.r])))]); },
      tool: (e, v) => {
        let w = way(three(v, e.a)); if (data.planar) w = toward([0, 0], w);
        const c = page(three(v, e.p)), s = [-w[1], w[0]], half = e.w < 0.05 ? 17.6 : 12.6;
        draw("body s4", [[1, 1], [-1, 1], [-1, -1], [1, -1]].map(([x, r]) => beyond(beyond(c, w, x * half), s, r * e.w * CM)), true, 1e3);
      },
      triad: (e, v) => {
        const c = page(three(v, e.p));
        if (e.b) {
          const w = e.a.map((k, i) => way(three(v, k)).map(x => x * [31, 23, 17][i])), sum = (i, j) => w.reduce((t, u) => t + u[i] * u[j], 0);
          const a = Math.sqrt(sum(0, 0)), b = sum(0, 1) / a, d = Math.sqrt(Math.max(0, sum(1, 1) - b * b));
          draw("body s2", [...Array(48).keys()].map(k => k * Math.PI / 24).map(s => [c[0] + a * Math.cos(s), c[1] + b * Math.cos(s) + d * Math.sin(s)]), true, dot(three(v, e.p), reader));
        }
        e.a.forEach((k, i) => { const w = way(three(v, k)), end = beyond(c, w, 40); arrow("body", c, end); label(e.l[i], end, toward(c, end)); });
      },
      arrow: (e, v) => { const [a, b] = e.p.map(k => page(three(v, k))); arrow("axis", a, b); label(e.l, b, toward(a, b)); },
      curve: (e, v) => { const q = sampled(e, v, 64)[0].map(page); if (e.c == "ground") ground(q); else if (e.c == "body") draw("body s2", q, true, 0); else draw(e.c, q); },
      surface: (e, v) => surface(sampled(e, v, 14)),
      trace: (e, v) => {
        const q = traced(e);
        if (!q || q.length < 2) return;
        if (e.v < 0) { draw("curve", q); return; }
        const push = way(three(v, e.v)).map(x => x * e.s), at = page(three(F["tra" + e.f](M.inFile(y, p), p), 3));
        let k = 0; for (let i = 0; i + 1 < q.length; i++) if (far(q[i], at) < far(q[k], at)) k = i;
        const w = toward(q[k], q[Math.min(k + 1, q.length - 1)]);
        ground(w[1] * push[0] - w[0] * push[1] > 0 ? q : q.reverse());
      },
      rest: (e, v) => {
        const at = page(three(v, e.p)), f = toward([0, 0], way(three(v, e.v))), c = page(three(v, e.c)), w = e.x && Math.abs(f[0] * (c[0] - at[0]) + f[1] * (c[1] - at[1])) < 1 ? f : [-f[1], f[0]];
        const right = [-w[1], w[0]], s = right[0] * (c[0] - at[0]) + right[1] * (c[1] - at[1]) > 0 ? -1 : 1;
        ground([beyond(at, w, -2 * width * s), beyond(at, w, 2 * width * s)]);
      },
      corner: (e, v) => {
        const c = page(three(v, e.p[0])), a = unit(three(v, e.p[1])), b = unit(three(v, e.p[2])), size = Math.acos(Math.max(-1, Math.min(1, dot(a, b))));
        if (size < 0.03) return;
        const side = unit(cross(cross(a, b), a)), points = [...Array(21).keys()].map(k => way(plus(a.map(x => x * Math.cos(size * k / 20)), side, Math.sin(size * k / 20)))).map(w => beyond(c, w, 28));
        for (const d of [a, b]) draw("reference", [c, beyond(c, way(d), 42)]);
        arc(points); label(e.l, points[10], toward(c, points[10]));
      },
      length: (e, v) => {
        const [a, b] = e.p.map(k => page(three(v, k))); if (far(a, b) < 8) return;
        const s = toward(a, b), side = [-s[1], s[0]];
        draw("dimension", [a, b]); for (const q of [a, b]) draw("dimension", [beyond(q, side, 4), beyond(q, side, -4)]);
        label(e.l, beyond(a, s, far(a, b) / 2), side);
      },
      angle: (e, v) => {
        const q = wrapped(y[e.q]), at = s => { const w = changed(e.q, s), a = three(w, e.p); return e.o === undefined ? a : plus(a, three(w, e.o), -1); };
        const here = at(y[e.q]), middle = plus(here, plus(at(y[e.q] + Math.PI), here, -1), 0.5), base = e.o === undefined ? middle : three(v, e.o);
        let c = base, end = plus(base, plus(here, middle, -1)), lift = [0, 0, 0];
        if (e.u) { const axis = cross(plus(at(0), middle, -1), plus(at(1), middle, -1)), k = axis.findIndex(x => Math.abs(x) > 0.999 * Math.hypot(...axis)); if (k >= 0 && Math.hypot(...base.filter((_, i) => i != k)) < 1e-6 * (1 + Math.abs(base[k]))) { draw("guide", [page(end), page(plus(end, base, -1))]); lift = base; c = [0, 0, 0]; end = plus(end, base, -1); } }
        if (e.g || e.u) draw("guide", [page(c), page(end)]);
        const reach = Math.hypot(...plus(end, c, -1)) || 1, r = data.planar ? Math.min(28, 0.8 * reach * scale) / (reach * scale) : Math.min(0.8, 29 / (reach * scale));
        const spoke = s => { const w = plus(at(s), middle, -1); return page(plus(c, w, r)); };
        draw("reference", [page(c), beyond(page(c), toward(page(c), spoke(0)), far(page(c), spoke(0)) + 14)]);
        if (Math.abs(q) > 0.05) arc([...Array(21).keys()].map(k => spoke(q * k / 20)));
        const mid = spoke(q / 2); label(e.l, mid, toward(page(c), mid));
      },
      turn: (e, v) => {
        const q = wrapped(y[e.q]), c = page(three(v, e.p)), spoke = s => beyond(c, toward([0, 0], way(three(changed(e.q, s), e.v))), 27);
        draw("reference", [c, beyond(c, toward(c, spoke(0)), 41)]); draw("reference", [c, beyond(c, toward(c, spoke(q)), 41)]);
        if (Math.abs(q) > 0.05) arc([...Array(21).keys()].map(k => spoke(q * k / 20)));
        const mid = spoke(q / 2); label(e.l, mid, toward(c, mid));
      },
      distance: (e, v) => {
        const s = y.slice(); e.q.forEach(k => { s[k] = 0; });
        let start = three(cells(s), e.p); const lift = e.f ? start : [0, 0, 0], ends = [start];
        e.q.forEach(k => { s[k] = y[k]; ends.push(three(cells(s), e.p)); });
        if (e.f) draw("guide", [page(ends.at(-1)), page(plus(ends.at(-1), lift, -1))]);
        const q = ends.map(x => page(plus(x, lift, -1)));
        e.q.forEach((_, i) => {
          let a = q[i], b = q[i + 1];
          if (e.q.length > 1 && data.planar && i < 2) { if (i == 0) { const w = [q[2][0] - q[1][0], q[2][1] - q[1][1]]; a = [a[0] + w[0], a[1] + w[1]]; b = [b[0] + w[0], b[1] + w[1]]; } }
          if (far(a, b) < 6) return;
          const w = toward(a, b), side = [-w[1], w[0]];
          if (data.shown.length == 1) { a = beyond(a, side, 31); b = beyond(b, side, 31); arc([a, beyond(a, w, far(a, b) / 2), b]); } else draw("guide", [a, b]);
          label(e.l[i], beyond(a, w, far(a, b) / 2), side);
        });
      },
      gravity: (e, v) => { const w = way(three(v, e.v)); if (Math.hypot(...w) < 1e-9) return; const s = toward([0, 0], w), a = [width - 26, 20 + (s[1] < 0 ? 38 : 0)], b = beyond(a, s, 38); arrow("axis", a, b); label(e.l, beyond(a, s, 19), [-1, 0]); },
    };
    function link(e, v, shape) {
      let [a, b] = e.p.map(k => page(three(v, k)));
      const w = toward(a, b), s = [-w[1], w[0]], middle = beyond(a, w, far(a, b) / 2);
      if (e.o) { const post = [beyond(a, w, 7), beyond(b, w, -7)], corner = post.map(q => beyond(q, s, e.o * CM)); draw("spring", [a, post[0], corner[0]]); draw("spring", [b, post[1], corner[1]]); [a, b] = corner; }
      shape(a, b);
      label(e.l, beyond(middle, s, e.o * CM + (e.o < 0 ? -6 : 6)), e.o < 0 ? [-s[0], -s[1]] : s, 4);
    }
    function halves(circle3, c) {
      for (let i = 0; i + 1 < circle3.length; i++) draw(dot(plus(circle3[i], c, -1), reader) >= 0 ? "grid" : "reference", [page(circle3[i]), page(circle3[i + 1])]);
    }

    // Displacements at this instant: δr of a virtual one, dr = δr + what moving constraints add in dt.
    function bound(s = y) {
      const m = data.shape.con[1], c = F.con(s, p), A = [...Array(m).keys()].map(i => c.slice(3 * m + i * n, 3 * m + i * n + n));
      const across = right => { const w = solved(A.map((r, i) => [...A.map(s => r.reduce((t, x, k) => t + x * s[k], 0)), right[i]]), m).x; return [...Array(n).keys()].map(k => A.reduce((t, r, i) => t + r[k] * w[i], 0)); };
      return { A, across, drift: c.slice(2 * m, 3 * m) };
    }
    function virtual(k) {
      const d = new Array(n).fill(0); d[k] = 1;
      if (!data.shape.con[1]) return d;
      const { A, across } = bound(), off = across(A.map(r => r[k]));
      return d.map((x, j) => x - off[j]);
    }
    function displacements(v) {
      const d = virtual(Number(one("select.which")?.value ?? 0)), e = 1e-5;
      const moved = (s, dq, dt) => { s = s.slice(); dq.forEach((x, j) => { s[j] += e * x; }); s[2 * dq.length] += e * dt; return s; };
      // What moving constraints add in dt: what the derivation states, in the file's coordinates; otherwise the least.
      const c = data.shape.con[1] && !F.car ? bound() : null, least = c ? c.across(c.drift).map(x => -x) : new Array(n).fill(0);
      const z = M.inFile(y, p), a = cells(moved(y, d, 0)), b = F.car ? F.fig(moved(z, F.car(z, p), 1), p) : cells(moved(y, least, 1));
      const parts = data.points.map(c => [three(v, c), plus(three(a, c), three(v, c), -1).map(x => x / e), plus(three(b, c), three(v, c), -1).map(x => x / e)]);
      const size = Math.max(1e-9, ...parts.map(q => Math.hypot(...flat(q[1])))), carried = Math.max(0, ...parts.map(q => Math.hypot(...flat(q[2]))));
      const first = 1.5 * CM / (size * scale), second = carried > 1e-9 ? 1.0 * CM / (carried * scale) : 0;
      for (const [at, virtual, transport] of parts) {
        const start = page(at), end = page(plus(at, virtual, first)), other = page(plus(plus(at, virtual, first), transport, second));
        if (on("possible")) { draw("guide", [end, other]); arrow("possible", start, other); tag("dr", other, toward(start, other)); if (second) draw("reference", [start, page(plus(at, transport, second))]); }
        if (on("virtual")) { arrow("virtual", start, end); tag("δr", end, toward(start, end)); }
      }
    }
    const on = name => { const box = one(`input[data-show="${name}"]`); return Boolean(box && box.checked); };
    let tags = [];
    const tag = (text, at, w) => tags.push([text, at, w]);

    // The points of a trace that are a pixel apart, and the last one.
    function thinned(points) {
      let last = points[0];
      return points.filter((q, i) => { const kept = !i || i + 1 == points.length || far(q, last) > 1; if (kept) last = q; return kept; });
    }
    function render() {
      out = []; labels = []; edges = []; tags = [];
      const v = cells(y), f = on("forces") ? M.forces(y, p) : { loads: [], reactions: [] }, acting = [...f.loads, ...f.reactions.flatMap(r => r.parts)];
      keepInView(v, acting);
      for (const e of data.items) kinds[e.k](e, v);
      if (data.axes && data.shown.length > 1) {
        const o = page([0, 0, 0]);
        data.shown.forEach((k, i) => { const e = [0, 0, 0]; e[k] = 1; const w = way(e), end = beyond(o, data.planar ? toward([0, 0], w) : w, 40); arrow("axis", o, end); tag("ijk"[k], end, toward(o, end), 1); });
      }
      if (on("trace") && trace.length > 1) data.points.forEach((_, i) => draw("trail", thinned(trace.map(q => page(q[i])))));
      if (on("forces")) {
        for (const [at, vector] of f.loads) { const a = page(at), w = way(vector); arrow("force", a, beyond(a, w, force)); }
        f.reactions.forEach(r => r.parts.forEach(([at, vector]) => { const a = page(at), w = way(vector); if (w.every(isFinite)) arrow("reaction", a, beyond(a, w, force)); }));
        const size = Math.pow(10, Math.floor(Math.log10(60 / force))), nice = [5, 2, 1].map(k => k * size).find(s => s * force <= 60) || size;
        if (forceSizes(y) > 0) { draw("dimension", [[14, height - 14], [14 + nice * force, height - 14]]); for (const x of [14, 14 + nice * force]) draw("dimension", [[x, height - 18], [x, height - 10]]); tag(number(nice) + (data.newton ? " N" : ""), [14 + nice * force, height - 14], [1, 0]); }
      }
      if (on("virtual") || on("possible")) displacements(v);
      paint();
      readings();
    }
    const solid = ["line", "capsule", "disc", "sphere", "box", "cone", "string", "spring", "damper", "dot"];
    // The boxes on the page of all that may move: [left, right, top, bottom] of each point with what is around it.
    function boxes(v) {
      const found = [];
      const add = (q, r = 0) => { const [x, y] = page(q); if (isFinite(x) && isFinite(y) && isFinite(r)) found.push([x - r, x + r, y - r, y + r]); };
      for (const e of data.items) {
        if (!solid.includes(e.k)) continue;
        if (Array.isArray(e.p)) e.p.forEach(k => Array.isArray(k) ? add(three(v, k[0]), Math.abs(v[k[1]]) * scale) : add(three(v, k)));
        else add(three(v, e.p), e.k == "dot" ? 0 : scale * (e.k == "box" ? Math.max(v[e.w[0]], v[e.w[1]]) / 2 : e.k == "cone" ? v[e.h] * 0.75 : Math.abs(v[e.r])));
      }
      return found;
    }
    // The picture follows a system that leaves it: all of it where it fits, otherwise its particles and mass centres.
    function keepInView(v, acting) {
      const middles = () => data.points.map(k => page(three(v, k))).filter(x => x.every(isFinite)).map(([x, y]) => [x, x, y, y]);
      let centres = middles();
      if (!centres.length) return;
      // Particles that have moved too far apart make the picture smaller.
      const share = Math.min(...[[0, width], [1, height]].map(([i, size]) => 0.8 * size / (Math.max(...centres.map(b => b[2 * i + 1])) - Math.min(...centres.map(b => b[2 * i])))));
      if (share < 1) { scale *= share; centres = middles(); }
      const tips = acting.map(([at, vector]) => beyond(page(at), way(vector), force)).filter(q => q.every(isFinite)).map(([x, y]) => [x, x, y, y]);
      const solids = [...centres, ...boxes(v)], all = [...solids, ...tips];
      for (const [i, size] of [[0, width], [1, height]]) for (const [list, least] of [[all, 12], [solids, 12], [centres, MARGIN * 0.7]]) {
        const low = Math.min(...list.map(b => b[2 * i])), high = Math.max(...list.map(b => b[2 * i + 1])), room = Math.min(least, size / 6);
        if (high - low > size - 2 * room) continue;
        const shift = low < room ? low - room : high > size - room ? high - size + room : 0;
        if (shift) centre[i] += (i ? -shift : shift) / scale;
        break;
      }
    }
    const pool = [], written = new WeakMap();
    // Sets an attribute that differs from what was set before: to set one costs much more than to compare.
    function assign(e, name, value) {
      let known = written.get(e);
      if (!known) written.set(e, known = {});
      if (known[name] === value) return;
      known[name] = value;
      if (value === null) e.removeAttribute(name); else e.setAttribute(name, value);
    }
    const shown = (e, visible) => assign(e, "display", visible ? null : "none");
    function paint() {
      const behind = out.filter(o => o[2] !== null).sort((a, b) => a[2] - b[2]), list = [...behind, ...out.filter(o => o[2] === null)];
      while (pool.length < list.length) pool.push(lines.appendChild(document.createElementNS(SVG, "path")));
      list.forEach((o, i) => { assign(pool[i], "class", o[0]); assign(pool[i], "d", o[1]); shown(pool[i], true); });
      for (let i = list.length; i < pool.length; i++) shown(pool[i], false);
      const used = new Set(), taken = [], marks = one("g.tags");
      const bounds = edges.map(framed);
      // A text beside a place, first in the direction w, where it covers least; it stays on its side if that is as good.
      function put(e, at, w, clear, a, b) {
        let least = Infinity, box, spot;
        for (let i = 0; i < 16; i++) {
          const k = i % 8, extra = 0.3 * k + (i < 8 ? 0 : 1.5) - (e.spot === i ? 0.9 : 0);
          if (extra >= least) continue;
          const turn = (k % 2 ? 1 : -1) * Math.ceil(k / 2) * Math.PI / 4, c = Math.cos(turn), s = Math.sin(turn), u = [w[0] * c - w[1] * s, w[0] * s + w[1] * c];
          const q = beyond(at, u, clear + (i < 8 ? 5 : 17) + Math.abs(u[0]) * a / 2 + Math.abs(u[1]) * b / 2), here = [q[0] - a / 2 - 1, q[0] + a / 2 + 1, q[1] - b / 2, q[1] + b / 2];
          let cost = extra + (here[0] < 0 || here[1] > width || here[2] < 0 || here[3] > height ? 8 : 0);
          for (const o of taken) if (overlap(o, here)) cost += 8;
          if (cost < least) cost += Math.min(6, 2 * met(here, bounds));
          if (cost < least) { least = cost; box = here; spot = i; }
        }
        e.spot = spot; taken.push(box); shown(e, true);
        assign(e, "x", ((box[0] + box[1]) / 2).toFixed(1)); assign(e, "y", ((box[2] + box[3]) / 2 + 5).toFixed(1));
      }
      while (marks.childNodes.length < tags.length) marks.append(document.createElementNS(SVG, "text"));
      marks.childNodes.forEach((e, i) => {
        shown(e, i < tags.length);
        if (i >= tags.length) return;
        const [text, at, w] = tags[i];
        if (e.textContent !== text) e.textContent = text;
        assign(e, "class", text.length == 1 ? "b" : "");
        put(e, at, w, 0, 6.8 * text.length, 13);
      });
      for (const [k, at, w, clear] of labels) {
        const e = texts[k];
        if (!e || !at.every(isFinite)) continue;
        shown(e, true);
        if (!e.size) e.size = Math.max(e.getBBox().width, 8);
        put(e, at, w, clear, e.size, 15); used.add(k);
      }
      texts.forEach((e, k) => { if (!used.has(k)) shown(e, false); });
    }

    // ---- What is written beside the figure

    const write = (name, text) => { const e = one(`[data-out="${name}"]`); if (e && e.textContent !== text) e.textContent = text; };
    function readings() {
      const e = integrals(y), f = data.bound.length ? M.forces(y, p).reactions : [];
      write("t", number(y[2 * n], 4));
      if (moving) { write("T", number(e.T)); write("V", number(e.V)); write("E", number(e.T + e.V)); write("drift", number(worst, 2)); }
      write("error", number(wrong, 2));
      data.conserved.forEach((_, i) => write(`I${i}`, number(e.I[i])));
      f.forEach((r, i) => write(`R${i}`, number(r.value)));
      if (F.sta) F.sta(y, p).slice(0, data.shape.sta[0]).forEach((q, i) => write(`Q${i}`, number(Math.abs(q) < 1e-9 ? 0 : q)));
      write("message", message || remark);
      if (document.activeElement?.dataset.q === undefined || playing) all("input[data-q]").forEach(i => { const k = Number(i.dataset.q); i.value = data.angles[k] ? wrapped(y[k]) : y[k]; });
      all("output[data-q]").forEach(o => { const k = Number(o.dataset.q); o.textContent = number(data.angles[k] ? wrapped(y[k]) : y[k]); });
      all("output[data-u]").forEach(o => { o.textContent = number(y[n + Number(o.dataset.u)]); });
      all("output[data-p]").forEach(o => { o.textContent = number(p[Number(o.dataset.p)]); });
    }

    // ---- Graphs

    function graph(canvas, curves, window_, faint = []) {
      if (!canvas || !canvas.clientWidth) return;
      const W = canvas.clientWidth, H = canvas.clientHeight, r = devicePixelRatio || 1;
      if (canvas.width != Math.round(W * r)) { canvas.width = Math.round(W * r); canvas.height = Math.round(H * r); }
      const g = canvas.getContext("2d"), style = getComputedStyle(root), colour = k => style.getPropertyValue(`--curve${k % 5}`).trim() || "#555";
      g.setTransform(r, 0, 0, r, 0, 0); g.clearRect(0, 0, W, H);
      let [x0, x1] = window_?.x || [Infinity, -Infinity], y0 = Infinity, y1 = -Infinity, count = 0;
      for (const c of [...curves, ...faint]) for (const [u, v] of c) {
        if (!isFinite(u) || !isFinite(v) || window_?.x && (u < x0 || u > x1)) continue;
        count++;
        if (!window_?.x) { if (u < x0) x0 = u; if (u > x1) x1 = u; }
        if (v < y0) y0 = v; if (v > y1) y1 = v;
      }
      if (count < 2) return;
      if (!(x1 - x0 > 1e-9)) { x0 -= 0.5; x1 += 0.5; }
      const pad = Math.max((y1 - y0) * 0.08, 1e-6 * Math.max(Math.abs(y1), 1), 1e-9); y0 -= pad; y1 += pad;
      const L = 46, B = 20, R = 8, T = 8, X = x => L + (x - x0) / (x1 - x0) * (W - L - R), Y = v => H - B - (v - y0) / (y1 - y0) * (H - B - T);
      const ticks = (a, b, count) => { const raw = (b - a) / count, s = Math.pow(10, Math.floor(Math.log10(raw))), step = [1, 2, 5, 10].map(k => k * s).find(k => k >= raw); const list = []; for (let v = Math.ceil(a / step) * step; v <= b + 1e-12; v += step) list.push(Math.abs(v) < step * 1e-6 ? 0 : v); return list; };
      g.font = "11px sans-serif"; g.lineWidth = 1; g.strokeStyle = style.getPropertyValue("--line"); g.fillStyle = style.getPropertyValue("--quiet");
      g.textAlign = "center"; g.textBaseline = "top";
      for (const v of ticks(x0, x1, Math.max(2, W / 90))) { g.beginPath(); g.moveTo(X(v), T); g.lineTo(X(v), H - B); g.stroke(); g.fillText(number(v), X(v), H - B + 4); }
      g.textAlign = "right"; g.textBaseline = "middle";
      for (const v of ticks(y0, y1, Math.max(2, H / 45))) { g.beginPath(); g.moveTo(L, Y(v)); g.lineTo(W - R, Y(v)); g.stroke(); g.fillText(number(v), L - 5, Y(v)); }
      g.save(); g.beginPath(); g.rect(L, 0, W - L - R, H - B); g.clip();
      [...faint, ...curves].forEach((c, j) => {
        const k = j % curves.length, pale = j < faint.length;
        g.globalAlpha = pale ? 0.5 : 1;
        g.strokeStyle = g.fillStyle = colour(k); g.lineWidth = 1.6; g.beginPath();
        const every = Math.max(1, Math.floor(c.length / 1200)); let pen = false;
        c.forEach((q, i) => { if (i % every && i < c.length - 1) return; if (!q.every(isFinite)) { pen = false; return; } if (pen) g.lineTo(X(q[0]), Y(q[1])); else g.moveTo(X(q[0]), Y(q[1])); pen = true; });
        g.stroke();
        const end = window_?.mark?.[k] || c.at(-1);
        if (!pale && end && end.every(isFinite)) { g.beginPath(); g.arc(X(end[0]), Y(end[1]), 3, 0, 7); g.fill(); }
      });
      g.restore();
    }
    function graphs() {
      const shown = shownAt >= 0 ? history.slice(0, shownAt + 1) : history, now = y[2 * n];
      if (moving) {
        const recent = shownAt >= 0 ? shown : shown.filter(h => h.y[2 * n] > now - 20), from = recent[0]?.y[2 * n] ?? 0;
        const x = shownAt >= 0 ? [history[0].y[2 * n], history.at(-1).y[2 * n]] : [from, Math.max(from + 8, now)];
        const ahead = shownAt >= 0 ? history.slice(shownAt) : history.length < 2 ? preview.filter(h => h.y[2 * n] <= x[1]) : [];
        const chosen = all("input[data-plot]").filter(b => b.checked).map(b => Number(b.dataset.plot));
        graph(one("canvas.coordinates"), [...Array(n).keys()].map(k => chosen.includes(k) ? recent.map(h => [h.y[2 * n], h.y[k]]) : []), { x }, [...Array(n).keys()].map(k => chosen.includes(k) ? ahead.map(h => [h.y[2 * n], h.y[k]]) : []));
        graph(one("canvas.reactions"), data.bound.map((_, k) => recent.map(h => [h.y[2 * n], h.r[k]])), { x }, data.bound.map((_, k) => ahead.map(h => [h.y[2 * n], h.r[k]])));
        const k = Number(one("select.phase")?.value ?? 0);
        graph(one("canvas.phase"), [shown.map(h => [h.y[k], h.y[n + k]])], null, [ahead.map(h => [h.y[k], h.y[n + k]])]);
      } else {
        const k = Number(one("select.phase")?.value ?? 0), input = one(`input[data-q="${k}"]`);
        if (!input || !F.sta) return;
        const a = Number(input.min), b = Number(input.max), curve = [], pieces = 240;
        const force = x => { const s = y.slice(); s[k] = x; return F.sta(s, p)[k]; };
        // The work against all forces, −∫ Q dq, which is 0 in the present position.
        let work = 0, before = null, zero = 0;
        for (let i = 0; i <= pieces; i++) {
          const x = a + (b - a) * i / pieces, Q = force(x), d = (b - a) / pieces;
          if (before !== null && isFinite(Q) && isFinite(before)) work -= (Q + before) / 2 * d;
          if (before !== null && x >= y[k] && x - d < y[k]) zero = work + (Q + force(y[k])) / 2 * (x - y[k]);
          before = Q; curve.push([x, isFinite(Q) ? work : NaN]);
        }
        graph(one("canvas.phase"), [curve.map(q => [q[0], q[1] - zero])], { x: [a, b], mark: [[y[k], 0]] });
      }
    }
    function show() { render(); graphs(); buttons(); }

    // ---- What the reader does

    let last = 0, frames = 0;
    function frame(now) {
      if (!playing) return;
      const dt = Math.min(0.05, (now - last) / 1000 || 1 / 60) * speed; last = now;
      if (!(shownAt >= 0 ? follow(dt) : run(dt))) stop();
      render();
      if (frames++ % 3 == 0) { graphs(); scrub(); }
      requestAnimationFrame(frame);
    }
    // A system that would stay at rest is pushed a little, which is said.
    function nudge() {
      if (!moving || M.rate(y, p).slice(0, 2 * n).some(x => Math.abs(x) > 1e-9) || data.timed) return;
      const s = y.slice();
      for (let i = 0; i < n; i++) s[n + i] += 0.01 * (1 + 0.3 * i);
      y = M.projected(s, p, -1); restart();
      message = "It would stay at rest here, and was pushed a little.";
    }
    const play = one("button.play");
    const called = (name, sign) => { if (play) { play.setAttribute("aria-label", name); play.textContent = `${sign} ${name}`; } };
    function stop() { playing = false; called("Play", "▶"); show(); scrub(); }
    function start() {
      if (!moving) return;
      message = "";
      if (shownAt < 0) nudge();
      if (calm.matches) { if (shownAt >= 0) follow(Infinity); run(10); message ||= "10 s of motion, computed at once: the slider “time” goes through it."; stop(); return; }
      playing = true; last = performance.now(); called("Pause", "❚❚");
      requestAnimationFrame(frame);
    }
    const time = one("input.time");
    function scrub() { if (time) { time.max = Math.max(1, history.length - 1); time.value = shownAt >= 0 ? shownAt : history.length - 1; time.disabled = playing || history.length < 2; } }
    play?.addEventListener("click", () => playing ? stop() : start());
    one("button.step")?.addEventListener("click", () => { if (playing) stop(); shownAt >= 0 ? follow(0.02) : run(0.02); show(); scrub(); });
    one("button.reset")?.addEventListener("click", () => {
      playing = false; shownAt = -1; p = data.p.slice(); y = begin(); touched = false;
      all("input[data-p]").forEach(i => { i.value = p[Number(i.dataset.p)]; });
      restart(); remember(); fit(); stop();
    });
    time?.addEventListener("input", () => { shownAt = Number(time.value); if (history[shownAt]) { y = history[shownAt].y.slice(); render(); graphs(); } });
    one("select.speed")?.addEventListener("change", e => { speed = Number(e.target.value); });
    all("input[data-q]").forEach(i => i.addEventListener("input", () => {
      const k = Number(i.dataset.q), s = y.slice(); s[k] = Number(i.value); s[2 * n] = moving ? s[2 * n] : 0;
      const next = M.projected(s, p, k);
      if (next.every(isFinite) && M.violation(next, p) < 1e-6) { y = next; touched = true; shownAt = -1; restart(); message = ""; } else message = "The constraints do not allow this value.";
      show(); scrub();
    }));
    let waiting = 0;
    all("input[data-p]").forEach(i => i.addEventListener("input", () => {
      const before = p.slice(), k = Number(i.dataset.p);
      p[k] = Number(i.value);
      const fresh = !touched && history.length < 2 && (data.begins.length || data.wanted.length);
      const next = fresh ? begin() : M.projected(y, p, -1);
      if (next.every(isFinite) && M.violation(next, p) < 1e-6) { y = next; shownAt = -1; restart(); message = ""; } else { p = before; message = "The constraints do not allow this value."; }
      clearTimeout(waiting); waiting = setTimeout(() => { fit(); if (data.rest) look(); show(); }, playing ? 600 : 150);
      show(); scrub();
    }));
    all("input[data-show], input[data-plot], select.phase, select.which").forEach(i => i.addEventListener("change", show));
    // Positions of rest, f(q, 0) = 0, by Newton's method from several starts, where the page has none in closed form.
    const turns = { "-2": "−π", "-1": "−π/2", 1: "π/2", 2: "π" };
    let rests = [];
    function look() {
      rests = [];
      const force = q => { const s = [...q, ...new Array(n).fill(0), 0]; return F.eq(s, p).slice(n * n, n * n + n); };
      const jacobian = q => q.map((_, j) => { const a = q.slice(), b = q.slice(); a[j] += 1e-5; b[j] -= 1e-5; const f = force(a), g = force(b); return f.map((x, i) => (x - g[i]) / 2e-5); });
      const size = Math.max(1e-9, ...force(y.slice(0, n)).map(Math.abs), ...jacobian(y.slice(0, n)).flat().map(Math.abs).filter(isFinite));
      for (let start = 0; start < Math.pow(4, n); start++) {
        let q = y.slice(0, n).map((x, i) => { const c = Math.floor(start / Math.pow(4, i)) % 4; return data.angles[i] ? [0.2, 1.3, 2.9, -1.3][c] : [x, 0.1, 1.7 * x + 0.5, -x][c]; });
        for (let turn = 0; turn < 60; turn++) {
          const f = force(q), J = jacobian(q), rows = f.map((_, i) => [...f.map((_, j) => J.reduce((t, c) => t + c[i] * c[j], 0) + (i == j ? 1e-14 * size * size : 0)), f[i]]);
          const w = solved(rows, n).x, d = J.map(c => c.reduce((t, x, i) => t + x * w[i], 0)), long = Math.hypot(...d);
          q = q.map((x, j) => x - d[j] * Math.min(1, 0.5 / (long || 1)));
          if (long < 1e-12 || !q.every(isFinite)) break;
        }
        if (!q.every(isFinite) || !(Math.max(...force(q).map(Math.abs)) < 1e-9 * size)) continue;
        q = q.map((x, i) => data.angles[i] ? wrapped(x) : x).map(x => Math.abs(x) < 1e-9 ? 0 : x).map((x, i) => data.angles[i] && Math.abs(x + Math.PI) < 1e-9 ? Math.PI : x);
        const idle = jacobian(q).map(c => c.every(x => Math.abs(x) < 1e-7 * size));
        if (rests.every(r => r.q.some((x, i) => !idle[i] && Math.abs(data.angles[i] ? wrapped(x - q[i]) : x - q[i]) > 1e-5)) && rests.length < 6) rests.push({ q, idle });
      }
      const bar = one("span.found");
      const still = force(y.slice(0, n)), never = data.never.some(k => Math.abs(still[k]) > 1e-9 * size);
      bar.textContent = rests.length ? "" : never ? bar.dataset.never : "none found by a search from several positions";
      rests.forEach((r, k) => {
        const b = document.createElement("button");
        b.type = "button";
        b.textContent = r.q.map((x, i) => r.idle[i] && n > 1 ? "" : `${data.names[i]} = ${data.angles[i] && turns[Math.round(x / Math.PI * 2)] && Math.abs(x / Math.PI * 2 - Math.round(x / Math.PI * 2)) < 1e-9 ? turns[Math.round(x / Math.PI * 2)] : number(x)}`).filter(Boolean).join(", ") || "anywhere";
        b.addEventListener("click", () => settle(y.map((x, i) => i < n ? (r.idle[i] ? x : r.q[i]) : i < 2 * n ? 0 : x)));
        bar.append(b);
      });
    }
    const settle = s => { playing = false; y = M.projected(s, p, -1); shownAt = -1; restart(); fit(); stop(); };
    const equilibrium = k => F["eql" + k](y, p);
    // How far a position is from rest: accelerations there, or generalized forces that no constraint balances.
    function unrest(s) {
      if (moving) return Math.max(...M.rate(s, p).slice(n, 2 * n).map(Math.abs));
      if (!F.sta) return NaN;
      let Q = F.sta(s, p).slice(0, n);
      if (data.shape.con[1]) { const { A, across } = bound(s), off = across(A.map(r => r.reduce((t, x, k) => t + x * Q[k], 0))); Q = Q.map((x, k) => x - off[k]); }
      return Math.max(...Q.map(Math.abs));
    }
    function buttons() { all("button[data-rest]").forEach(b => { b.disabled = !equilibrium(Number(b.dataset.rest)).every(isFinite); b.title = b.disabled ? "There is no such equilibrium for these values." : ""; }); }
    all("button[data-rest]").forEach(b => b.addEventListener("click", () => {
      const k = Number(b.dataset.rest), v = equilibrium(k), targets = data.buttons[k], s = y.slice(), before = p.slice();
      targets.forEach((q, i) => { if (q >= 0) s[q] = v[i]; else { p[-1 - q] = v[i]; const slider = one(`input[data-p="${-1 - q}"]`); if (slider) slider.value = v[i]; } });
      for (let i = 0; i < n; i++) s[n + i] = 0;
      // cos θ = c holds at θ and −θ, sin θ = s at θ and π − θ, tan θ = a at θ and θ + π: take the one that is at rest.
      let best = s, least = Infinity;
      for (let choice = 0; choice < Math.pow(4, Math.min(3, targets.length)) && !(least < 1e-7); choice++) {
        const tried = s.slice();
        targets.forEach((q, i) => { if (q >= 0 && data.angles[q]) { const x = s[q]; tried[q] = wrapped([x, -x, Math.PI - x, x + Math.PI][Math.floor(choice / Math.pow(4, i)) % 4]); } });
        const placed = M.projected(tried, p, -1), u = unrest(placed);
        if (u < least) { least = u; best = placed; }
      }
      root.dataset.unrest = least;
      if (!(least < 1e-5)) { p = before; message = "There is no such equilibrium for these values."; show(); return; }
      settle(best);
    }));
    one("button.push")?.addEventListener("click", () => { const s = y.slice(); for (let i = 0; i < n; i++) s[n + i] += 0.05 * (1 + 0.3 * i); y = M.projected(s, p, -1); shownAt = -1; restart(); if (!playing) start(); });
    root.addEventListener("keydown", e => { if (e.key == " " && !e.target.closest("button, select, [type=checkbox]") || e.key == "Enter" && e.target === stage) { e.preventDefault(); playing ? stop() : start(); } });
    // For tests and programs: runs at once, and leaves the numbers as attributes of the figure.
    root.addEventListener("lagsolve-run", e => {
      if (shownAt >= 0 && e.detail.seconds) { history.length = shownAt + 1; shownAt = -1; }
      if (shownAt < 0) nudge();
      const begun = performance.now(), done = run(e.detail.seconds);
      Object.assign(root.dataset, { state: JSON.stringify(y), parameters: JSON.stringify(p), drift: worst, error: wrong, done, milliseconds: (performance.now() - begun) / Math.max(1, e.detail.seconds * 60) });
      const drawn = performance.now(); show(); root.dataset.drawing = performance.now() - drawn; scrub();
    });
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", graphs);
    root.hidden = false;
    document.documentElement.classList.add("moves");
    new ResizeObserver(() => { const W = stage.clientWidth; if (W && Math.abs(W - width) > 2) requestAnimationFrame(() => { fit(); show(); }); }).observe(stage);
    const which = one("select.which");
    if (which && data.shape.con[1]) which.value = Math.max(0, [...Array(n).keys()].findIndex(k => { const d = virtual(k); return Math.hypot(...d) > 0.3; }));
    restart(); remember(); fit(); if (data.rest) look(); show(); scrub();
  };
})();
