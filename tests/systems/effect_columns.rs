//! A column of effects that some rows have gives back what was put in, whatever rows those are.

use archetrace::trace::EffectColumn;

use crate::support::random::Random;

/// Columns in which every row has the effect with this probability.
fn check(probability: f64, rows: usize, random: &mut Random) {
    let expected: Vec<Option<usize>> =
        (0..rows).map(|row| (random.unit() < probability).then_some(row)).collect();
    let mut column = EffectColumn::default();
    expected.iter().for_each(|&row| column.push(row));
    let found: Vec<Option<usize>> = (0..rows).map(|row| column.get(row).copied()).collect();
    assert_eq!(found, expected);
    assert_eq!(column.len(), expected.iter().flatten().count());
    assert_eq!(column.get(rows), None);
    for (row, before) in expected.iter().enumerate() {
        assert_eq!(column.replace(row, Some(row + 1000)), before.is_some());
        assert_eq!(column.get(row).copied(), before.map(|row| row + 1000));
        assert_eq!(column.replace(row, None), before.is_none());
    }
}

#[test]
fn rows_come_back_whether_all_some_or_none_have_the_effect() {
    let random = &mut Random::new(77);
    for rows in 0..40 {
        for probability in [0.0, 0.1, 0.5, 0.9, 1.0] {
            check(probability, rows, random);
        }
    }
}
