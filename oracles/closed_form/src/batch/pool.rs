//! The lanes at work: cases are put into them, impacts are taken out, and a lane whose case has ended gets the next one.

use contract::{Ending, Limit};

use super::{
    Rows, Sequence, Tally, Work,
    blocks::{Blocks, Landed},
    lanes::Lanes,
    single::{Finished, Single},
};

/// How many impacts are collected before they are written to their rows.
const HELD: usize = 16;

/// The most lanes that there are.
const MOST_LANES: usize = 16;

/// A case in its lane.
#[derive(Clone, Copy)]
struct Place {
    case: usize,
    /// How many of its impacts are written.
    written: usize,
}

/// One quantity of the impacts that are not written yet, in all lanes.
type Held = [[f64; MOST_LANES]; HELD];

/// Lanes with the cases that are in them.
struct Pool<'a, 'r, L: Lanes> {
    work: &'a Work<'a>,
    rows: &'a mut Rows<'r>,
    blocks: Blocks<L>,
    /// What is in each lane, if anything.
    places: [Option<Place>; MOST_LANES],
    /// How many lanes are free.
    free: usize,
    /// The case to be taken next.
    next: usize,
    held: [Held; 3],
    count: usize,
    /// How many impacts may be held until a lane is full.
    room: usize,
    tally: Tally,
}

/// Follows all cases of the work.
#[inline(always)]
pub(super) fn run<L: Lanes>(zero: L, work: &Work, rows: &mut Rows) -> Tally {
    let mut pool = Pool {
        work,
        rows,
        blocks: Blocks::idle(zero),
        places: [None; MOST_LANES],
        free: L::COUNT,
        next: 0,
        held: [[[0.0; MOST_LANES]; HELD]; 3],
        count: 0,
        room: 0,
        tally: Tally::default(),
    };
    // Flights to the side of the first, and then to the other: all lanes are on the same side.
    while pool.refill() {
        pool.fly::<true>();
        pool.fly::<false>();
    }
    pool.tally
}

impl<L: Lanes> Pool<'_, '_, L> {
    /// Puts cases into the lanes that are free, if half of them are; whether any lane is busy then.
    ///
    /// To wait for half of them keeps the lanes in step: the first flights are long, and ask for more terms of the series than the later ones.
    #[inline(always)]
    fn refill(&mut self) -> bool {
        if 2 * self.free >= L::COUNT && self.next < self.work.epsilon.len() {
            self.write();
            self.take_cases();
            self.blocks.prepare();
        }
        self.free < L::COUNT
    }

    /// Puts cases into the free lanes.
    #[inline(never)]
    fn take_cases(&mut self) {
        let Work { epsilon, omega, eta, impacts } = *self.work;
        let mut cases = epsilon.iter().zip(omega).zip(eta).enumerate().skip(self.next);
        let blocks = &mut self.blocks;
        for (lane, place) in self.places.iter_mut().enumerate().take(L::COUNT) {
            if place.is_some() {
                continue;
            }
            for (case, ((epsilon, omega), eta)) in cases.by_ref() {
                self.next = case + 1;
                if *epsilon > 0.0 {
                    blocks.start(lane, *epsilon, *omega, *eta);
                    *place = Some(Place { case, written: 0 });
                    self.free -= 1;
                    break;
                }
                self.rows.end(case, impacts, Sequence { impacts: 0, ending: Ending::NeverRocks });
            }
        }
        self.measure();
    }

    /// One flight of every lane.
    #[inline(always)]
    fn fly<const FIRST_SIDE: bool>(&mut self) {
        let landed = self.blocks.fly::<FIRST_SIDE>();
        if L::any(landed.unsure) {
            let unsure = landed.time.all(1.0).or(landed.unsure, landed.time.all(0.0));
            self.alone(&landed, &unsure, if FIRST_SIDE { -1.0 } else { 1.0 });
        } else {
            self.hold(&landed.time, &landed.interval, &landed.velocity);
        }
        if self.count == self.room {
            self.write();
            self.finish();
        } else if self.count == HELD {
            self.write();
        }
    }

    #[inline(always)]
    fn hold(&mut self, time: &L, interval: &L, velocity: &L) {
        for (held, quantity) in self.held.iter_mut().zip([time, interval, velocity]) {
            if let Some(place) = held.get_mut(self.count) {
                quantity.copy_to(place);
            }
        }
        self.count += 1;
    }

    /// Writes the impacts that are held.
    #[inline(never)]
    fn write(&mut self) {
        let count = self.count;
        for (lane, place) in self.places.iter_mut().enumerate().take(L::COUNT) {
            let Some(place) = place else { continue };
            let start = place.case * self.work.impacts + place.written;
            for (row, held) in self.rows.quantities().into_iter().zip(&self.held) {
                let Some(row) = row.get_mut(start..start + count) else { continue };
                for (slot, lanes) in row.iter_mut().zip(held) {
                    *slot = lanes.get(lane).copied().unwrap_or(f64::NAN);
                }
            }
            place.written += count;
        }
        self.room = self.room.saturating_sub(count);
        self.count = 0;
    }

    /// Ends the cases that have all the impacts that are asked for.
    #[inline(never)]
    fn finish(&mut self) {
        for lane in 0..L::COUNT {
            let Some(Some(place)) = self.places.get(lane) else { continue };
            if place.written == self.work.impacts {
                let complete = self.blocks.complete.lane(lane) == 1.0;
                self.end(lane, if complete { Ending::AtRest } else { Ending::LimitReached(Limit::Impacts) });
            }
        }
        self.measure();
    }

    /// How many impacts may be held until a lane is full.
    fn measure(&mut self) {
        let written = self.places.iter().flatten().map(|place| place.written);
        self.room = self.work.impacts - written.max().unwrap_or(0);
    }

    fn end(&mut self, lane: usize, ending: Ending) {
        self.blocks.busy.set_lane(lane, 0.0);
        if let Some(Place { case, written }) = self.places.get_mut(lane).and_then(Option::take) {
            self.free += 1;
            self.rows.end(case, self.work.impacts, Sequence { impacts: written, ending });
            self.tally.impacts += written as u64;
        }
    }

    /// The flights that the lanes are not sure of, by the scalar code; the others as they are.
    #[cold]
    #[inline(never)]
    fn alone(&mut self, landed: &Landed<L>, unsure: &L, sign: f64) {
        self.write();
        let Landed { mut time, mut interval, mut velocity, before, .. } = *landed;
        let mut last = [None; MOST_LANES];
        for (lane, last) in last.iter_mut().enumerate().take(L::COUNT) {
            if unsure.lane(lane) != 1.0 {
                continue;
            }
            self.tally.alone += 1;
            let mut single = Single::new(&self.blocks, before, sign, lane);
            match single.fly() {
                // What has ended without this impact is gone before it is written.
                Some(Finished { ending, listed: false }) => {
                    self.end(lane, ending);
                    continue;
                }
                Some(Finished { ending, .. }) => *last = Some(ending),
                None => {}
            }
            for (quantity, value) in [&mut time, &mut interval, &mut velocity].into_iter().zip(single.impact()) {
                quantity.set_lane(lane, value);
            }
            single.put_into(&mut self.blocks, lane);
        }
        self.hold(&time, &interval, &velocity);
        if last.iter().any(Option::is_some) {
            self.write();
        }
        for (lane, ending) in last.into_iter().enumerate() {
            if let Some(ending) = ending {
                self.end(lane, ending);
            }
        }
        self.measure();
    }
}
