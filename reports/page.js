// Draws the plots of a page from its data. What is drawn was decided by the program that wrote
// the page; here a plot only gets its view (the reader's choice of map, abscissa, formula).
(function () {
  'use strict';
  const sheet = JSON.parse(document.getElementById('plumb-data').textContent);
  const ink = '#22262b', soft = '#59616c', line = '#e3e6ea';
  Chart.defaults.font.family = getComputedStyle(document.body).fontFamily;
  Chart.defaults.font.size = 13;
  Chart.defaults.color = ink;
  Chart.defaults.animation = false;

  const number = (x) => (x === 0 ? '0' : Math.abs(x) < 1e-3 || Math.abs(x) >= 1e5
    ? x.toExponential(2) : String(Number(x.toPrecision(4))));

  function points(series, column) {
    const x = sheet.columns[series.x], y = sheet.columns[column];
    const minus = 'minus' in series ? sheet.columns[series.minus] : null;
    return x.map((at, i) => ({
      x: at,
      y: y[i] === null || (minus && minus[i] === null) ? NaN : y[i] - (minus ? minus[i] : 0),
    }));
  }

  const shapes = ['circle', 'triangle', 'rect', 'rectRot', 'crossRot'];

  function datasets(series) {
    const base = {
      label: series.label, mark: series.mark, borderColor: series.color, backgroundColor: series.color,
      borderWidth: 2, pointRadius: 0, pointHitRadius: 6, showLine: true, tension: 0,
    };
    if (series.mark === 'band') {
      const edge = { ...base, borderWidth: 0, pointHitRadius: 0, backgroundColor: series.color + '66' };
      return [
        { ...edge, data: points(series, series.y), fill: '+1' },
        { ...edge, data: points(series, series.high), label: '', fill: false },
      ];
    }
    if (series.mark === 'dots') {
      return [{ ...base, data: points(series, series.y), pointRadius: 2.4, borderWidth: series.joined || series.shape === 4 ? 1.5 : 0,
        pointStyle: shapes[(series.shape || 0) % shapes.length], showLine: Boolean(series.joined) }];
    }
    return [{ ...base, data: points(series, series.y), borderDash: series.mark === 'dashed' ? [6, 4] : [] }];
  }

  // What stands for a series in the legend, drawn as the series is.
  function swatch(set) {
    const canvas = document.createElement('canvas');
    canvas.width = 24;
    canvas.height = 12;
    const pen = canvas.getContext('2d');
    pen.fillStyle = set.backgroundColor;
    pen.strokeStyle = set.borderColor;
    pen.lineWidth = 2;
    if (set.mark === 'band') {
      pen.fillRect(2, 1, 20, 10);
      return canvas;
    }
    if (set.mark !== 'dots' || set.showLine) {
      pen.setLineDash(set.borderDash || []);
      pen.beginPath();
      pen.moveTo(1, 6);
      pen.lineTo(23, 6);
      pen.stroke();
    }
    if (set.mark === 'dots') {
      Chart.helpers.drawPoint(pen, { pointStyle: set.pointStyle, radius: 4, borderWidth: set.borderWidth }, 12, 6);
    }
    return canvas;
  }

  function legend(chart) {
    return chart.data.datasets.map((set, i) => ({
      text: set.label, datasetIndex: i, hidden: !chart.isDatasetVisible(i), pointStyle: swatch(set),
    })).filter((item) => item.text);
  }

  function scale(axis) {
    return {
      type: axis.log ? 'logarithmic' : 'linear',
      min: axis.min, max: axis.max,
      title: { display: true, text: axis.label, color: ink, font: { size: 13 } },
      grid: { color: line, borderColor: soft },
      ticks: axis.log ? {
        color: soft, autoSkip: false,
        // Decades and their 2 and 5 only, or the labels run into each other.
        callback: (value) => ([1, 2, 5].includes(Math.round(value / 10 ** Math.floor(Math.log10(value) + 1e-9)))
          ? number(value) : null),
      } : { color: soft, callback: number },
    };
  }

  function selection(group) {
    const chosen = {};
    document.querySelectorAll('select[data-group="' + group + '"]').forEach((select) => {
      chosen[select.dataset.key] = select.value;
    });
    return chosen;
  }

  const charts = new Map();

  function draw(plot) {
    const chosen = selection(plot.group);
    const view = plot.views.find((one) =>
      Object.entries(one.keys).every(([key, value]) => !(key in chosen) || chosen[key] === value));
    const old = charts.get(plot.id);
    if (old) old.destroy();
    charts.set(plot.id, new Chart(document.getElementById(plot.id), {
      type: 'scatter',
      data: { datasets: view ? view.series.flatMap(datasets) : [] },
      options: {
        responsive: true, maintainAspectRatio: false, normalized: true,
        scales: { x: scale((view && view.x) || plot.x), y: scale((view && view.y) || plot.y) },
        plugins: {
          legend: {
            position: 'bottom',
            labels: { usePointStyle: true, pointStyleWidth: 24, boxHeight: 12, padding: 8,
              font: { size: 12 }, generateLabels: legend },
          },
          tooltip: { callbacks: { label: (item) => (item.dataset.label ? item.dataset.label + ': ' : '') +
            number(item.parsed.x) + ', ' + number(item.parsed.y) } },
        },
      },
    }));
  }

  sheet.plots.forEach(draw);
  document.querySelectorAll('select[data-group]').forEach((select) => {
    select.addEventListener('change', () => {
      sheet.plots.filter((plot) => String(plot.group) === select.dataset.group).forEach(draw);
    });
  });
  window.addEventListener('beforeprint', () => charts.forEach((chart) => chart.resize()));
  window.addEventListener('afterprint', () => charts.forEach((chart) => chart.resize()));
}());
