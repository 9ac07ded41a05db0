//! The lanes at work: cases are put into them, impacts are taken out, and a lane whose case has ended gets the next one.

use contract::{Ending, Limit};

use super::{
    Rows, Sequence, Tally, Work,
    blocks::{Blocks, Landed},
    lanes::{Lanes, Twofold},
    single::{Finished, Single},
};

/// How many impacts are collected before they are written to their rows.
const HELD: usize = 16;

/// The most lanes that there are.
const MOST_LANES: usize = 32;

/// A case in its lane.
#[derive(Clone, Copy)]
struct Place {
    case: usize,
    /// How many of its impacts are written.
    written: usize,
}

/// Lanes with the cases that are in them.
struct Pool<'a, 'r, L: Lanes> {
    work: &'a Work<'a>,
    rows: &'a mut Rows<'r>,
    blocks: Blocks<L>,
    /// What is in each lane, if anything.
    places: [Option<Place>; MOST_LANES],
    /// The case to be taken next.
    next: usize,
    /// Impacts that are not written yet: time, interval and velocity of all lanes, for each impact.
    held: [[[f64; MOST_LANES]; 3]; HELD],
    count: usize,
    /// How many more impacts the lane has room for that has least.
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
        next: 0,
        held: [[[0.0; MOST_LANES]; 3]; HELD],
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
    /// Puts cases into the lanes that are free; whether any lane is busy then.
    #[inline(always)]
    fn refill(&mut self) -> bool {
        if self.places.iter().take(L::COUNT).all(Option::is_some) {
            return true;
        }
        self.write();
        self.take_cases()
    }

    #[inline(never)]
    fn take_cases(&mut self) -> bool {
        let mut busy = self.blocks.omega.all(0.0);
        for (lane, place) in self.places.iter_mut().enumerate().take(L::COUNT) {
            while place.is_none() && self.next < self.work.epsilon.len() {
                let case = self.next;
                self.next += 1;
                match Single::new(self.work, case) {
                    Some(single) => {
                        single.put_into(&mut self.blocks, lane);
                        *place = Some(Place { case, written: 0 });
                    }
                    None => self.rows.end(case, self.work.impacts, Sequence { impacts: 0, ending: Ending::NeverRocks }),
                }
            }
            busy.set_lane(lane, if place.is_some() { 1.0 } else { 0.0 });
        }
        self.blocks.busy = busy.all(0.5).below(busy);
        self.measure();
        L::any(self.blocks.busy)
    }

    /// One flight of every lane.
    #[inline(always)]
    fn fly<const FIRST_SIDE: bool>(&mut self) {
        let landed = self.blocks.fly::<FIRST_SIDE>();
        if L::any(landed.unsure) {
            self.write();
            self.alone(&landed, if FIRST_SIDE { -1.0 } else { 1.0 });
        } else {
            self.hold(&landed.time, &landed.interval, &landed.velocity);
        }
        if self.count == self.room || self.count == HELD {
            self.write();
            self.finish();
        }
    }

    #[inline(always)]
    fn hold(&mut self, time: &L, interval: &L, velocity: &L) {
        if let Some([times, intervals, velocities]) = self.held.get_mut(self.count) {
            time.copy_to(times);
            interval.copy_to(intervals);
            velocity.copy_to(velocities);
        }
        self.count += 1;
    }

    /// Writes the impacts that are held.
    #[inline(never)]
    fn write(&mut self) {
        for (lane, place) in self.places.iter_mut().enumerate().take(L::COUNT) {
            let Some(place) = place else { continue };
            let start = place.case * self.work.impacts + place.written;
            for (row, quantity) in self.rows.quantities().into_iter().zip(0..) {
                let Some(row) = row.get_mut(start..start + self.count) else { continue };
                for (slot, held) in row.iter_mut().zip(&self.held) {
                    *slot = held.get(quantity).and_then(|of| of.get(lane)).copied().unwrap_or(f64::NAN);
                }
            }
            place.written += self.count;
        }
        self.room = self.room.saturating_sub(self.count);
        self.count = 0;
    }

    /// Ends the cases that have all the impacts that are asked for.
    #[inline(never)]
    fn finish(&mut self) {
        for lane in 0..L::COUNT {
            let Some(Some(place)) = self.places.get(lane).copied() else { continue };
            if place.written == self.work.impacts {
                let ending = if self.blocks.complete.lane(lane) == 1.0 {
                    Ending::AtRest
                } else {
                    Ending::LimitReached(Limit::Impacts)
                };
                self.end(lane, ending);
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
        if let Some(place) = self.places.get_mut(lane) {
            if let Some(Place { case, written }) = place.take() {
                self.rows.end(case, self.work.impacts, Sequence { impacts: written, ending });
                self.tally.impacts += written as u64;
            }
            let mut free = self.blocks.omega.all(0.0);
            free.set_lane(lane, 1.0);
            self.blocks.busy = self.blocks.busy & free.below(free.all(0.5));
        }
    }

    /// The flights that the lanes are not sure of, by the scalar code; the others as they are.
    #[cold]
    #[inline(never)]
    fn alone(&mut self, landed: &Landed<L>, sign: f64) {
        let Landed { mut time, mut interval, mut velocity, unsure, before } = *landed;
        let mut ended: [Option<(Ending, bool)>; MOST_LANES] = [None; MOST_LANES];
        let one = time.all(1.0);
        let unsure = one.or(unsure, time.all(0.0));
        for (lane, ending) in ended.iter_mut().enumerate().take(L::COUNT) {
            let (Some(Some(place)), true) = (self.places.get(lane), unsure.lane(lane) == 1.0) else { continue };
            self.tally.alone += 1;
            let Some(mut single) = Single::new(self.work, place.case) else { continue };
            let [start, speed] = before;
            let lane_of = |of: Twofold<L>| crate::twofold::Twofold { high: of.high.lane(lane), low: of.low.lane(lane) };
            single.resume(lane_of(start), lane_of(speed), sign, self.blocks.complete.lane(lane) == 1.0);
            let finished = single.fly();
            let listed = !matches!(finished, Some(Finished { listed: false, .. }));
            if listed {
                let [now, stretch, departure] = single.impact();
                time.set_lane(lane, now);
                interval.set_lane(lane, stretch);
                velocity.set_lane(lane, departure);
                single.put_into(&mut self.blocks, lane);
            }
            *ending = finished.map(|finished| (finished.ending, listed));
        }
        // What has ended without this impact is gone before it is written.
        for listed in [false, true] {
            for (lane, ending) in ended.iter().enumerate() {
                if let Some((ending, is_listed)) = ending
                    && *is_listed == listed
                {
                    self.end(lane, *ending);
                }
            }
            if !listed {
                self.hold(&time, &interval, &velocity);
                self.write();
            }
        }
        self.measure();
    }
}
