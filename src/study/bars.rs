//! A picture of what effects cost.

use plotters::coord::ranged1d::IntoSegmentedCoord as _;
use plotters::coord::ranged1d::SegmentValue;
use plotters::prelude::*;

use super::Ablation;

/// Milliseconds that each present effect adds, the median as a bar and the quartiles' distance as a line on it, as an SVG
/// document; `None` if it cannot be drawn.
pub fn draw_bars(title: &str, ablation: &Ablation) -> Option<String> {
    let bars: Vec<Bar> = ablation
        .effects
        .iter()
        .filter_map(|price| {
            let added = price.without?.milliseconds;
            Some(Bar { name: price.count.effect.name(), median: added.median, iqr: added.iqr })
        })
        .collect();
    let mut svg = String::new();
    draw(&mut svg, title, &bars).ok()?;
    Some(svg)
}

struct Bar {
    name: &'static str,
    median: f64,
    iqr: f64,
}

fn draw(svg: &mut String, title: &str, bars: &[Bar]) -> Result<(), Box<dyn core::error::Error>> {
    const BAR_COLOR: RGBColor = RGBColor(62, 109, 156);
    let rows = bars.len().max(1);
    let height = 90 + 28 * u32::try_from(rows)?;
    let root = SVGBackend::with_string(svg, (720, height)).into_drawing_area();
    root.fill(&WHITE)?;
    let ends = bars.iter().flat_map(|bar| [bar.median - bar.iqr / 2.0, bar.median + bar.iqr / 2.0]);
    let (low, high) = ends.fold((0.0_f64, 0.0_f64), |(low, high), end| (low.min(end), high.max(end)));
    let margin = (high - low).max(f64::MIN_POSITIVE) / 20.0;
    let mut chart = ChartBuilder::on(&root)
        .caption(title, ("sans-serif", 18))
        .margin(10)
        .x_label_area_size(36)
        .y_label_area_size(120)
        .build_cartesian_2d(low - margin..high + margin, (0..rows).into_segmented())?;
    let name_of = |place: &SegmentValue<usize>| match place {
        SegmentValue::CenterOf(row) => bars.get(*row).map_or("", |bar| bar.name).replace('_', " "),
        _ => String::new(),
    };
    chart
        .configure_mesh()
        .disable_y_mesh()
        .x_desc("milliseconds that the effect adds to the frame")
        .y_labels(rows)
        .y_label_formatter(&name_of)
        .draw()?;
    chart.draw_series(bars.iter().enumerate().map(|(row, bar)| {
        let corners = [(0.0, SegmentValue::Exact(row)), (bar.median, SegmentValue::Exact(row + 1))];
        let mut rectangle = Rectangle::new(corners, BAR_COLOR.filled());
        rectangle.set_margin(5, 5, 0, 0);
        rectangle
    }))?;
    chart.draw_series(bars.iter().enumerate().map(|(row, bar)| {
        let half = bar.iqr / 2.0;
        let ends = [bar.median - half, bar.median + half].map(|x| (x, SegmentValue::CenterOf(row)));
        PathElement::new(ends, BLACK.stroke_width(2))
    }))?;
    root.present()?;
    Ok(())
}
