//! The lanes at work: cases are put into them, impacts are taken out, and a lane whose case has ended gets the next one.

use contract::{Ending, Limit};

use super::{
    CHUNK, Rows, Sequence, Tally, Work,
    blocks::Impact,
    lanes::Lanes,
    order,
    single::{Finished, Single},
    state::Blocks,
};

/// How many impacts are collected before they are written to their rows.
const HELD: usize = 32;

/// The most lanes that there are.
const MOST_LANES: usize = 24;

/// A case in its lane.
#[derive(Clone, Copy)]
struct Place {
    case: usize,
    /// How many of its impacts are written.
    written: usize,
}

/// The lanes of a register, and their impacts that are not written yet.
#[derive(Clone, Copy)]
#[repr(align(64))]
struct Group<L: Lanes> {
    blocks: Blocks<L>,
    held: [Impact<L>; HELD],
}

/// Lanes with the cases that are in them, in groups of a register each. A flight is a long chain of operations that wait for each other; the processor
/// works on the next group meanwhile.
struct Pool<'a, 'r, L: Lanes, const GROUPS: usize> {
    work: &'a Work<'a>,
    rows: &'a mut Rows<'r>,
    groups: [Group<L>; GROUPS],
    /// What is in each lane, if anything.
    places: [Option<Place>; MOST_LANES],
    /// How many lanes are free.
    free: usize,
    /// The cases in the order in which they are taken, and how many are.
    order: [u16; CHUNK],
    next: usize,
    /// How many impacts are held in each lane.
    count: usize,
    /// How many impacts may be held until a lane is full.
    room: usize,
    tally: Tally,
}

/// Follows all cases of the work, `GROUPS` registers at a time.
#[inline(always)]
pub(super) fn run<L: Lanes, const GROUPS: usize>(zero: L, work: &Work, rows: &mut Rows) -> Tally {
    rows.clear();
    let none = Impact { time: zero, interval: zero, velocity: zero };
    let mut pool = Pool::<L, GROUPS> {
        work,
        rows,
        groups: [Group { blocks: Blocks::idle(zero), held: [none; HELD] }; GROUPS],
        places: [None; MOST_LANES],
        free: GROUPS * L::COUNT,
        order: order::alike(work),
        next: 0,
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

impl<L: Lanes, const GROUPS: usize> Pool<'_, '_, L, GROUPS> {
    /// How many lanes there are.
    const LANES: usize = {
        assert!(GROUPS * L::COUNT <= MOST_LANES);
        GROUPS * L::COUNT
    };

    /// Puts cases into the lanes that are free, if half of them are; whether any lane is busy then.
    ///
    /// To wait for half of them keeps the lanes in step: the first flights are long, and ask for more terms of the series than the later ones.
    #[inline(always)]
    fn refill(&mut self) -> bool {
        if 2 * self.free >= Self::LANES && self.next < self.work.epsilon.len() {
            self.write();
            self.take_cases();
            for group in &mut self.groups {
                group.blocks.prepare();
            }
        }
        self.free < Self::LANES
    }

    /// Puts cases into the free lanes.
    #[inline(never)]
    fn take_cases(&mut self) {
        let Work { epsilon, omega, eta, .. } = *self.work;
        let mut cases = self.order.iter().take(epsilon.len()).skip(self.next);
        for (lane, place) in self.places.iter_mut().enumerate().take(Self::LANES) {
            if place.is_some() {
                continue;
            }
            for case in cases.by_ref() {
                let case = usize::from(*case);
                self.next += 1;
                let (Some(epsilon), Some(omega), Some(eta)) = (epsilon.get(case), omega.get(case), eta.get(case))
                else {
                    continue;
                };
                if *epsilon > 0.0 {
                    if let Some(group) = self.groups.get_mut(lane / L::COUNT) {
                        group.blocks.start(lane % L::COUNT, *epsilon, *omega, *eta);
                    }
                    *place = Some(Place { case, written: 0 });
                    self.free -= 1;
                    break;
                }
                self.rows.end(case, Sequence { impacts: 0, ending: Ending::NeverRocks });
            }
        }
        self.measure();
    }

    /// One flight of every lane.
    #[inline(always)]
    fn fly<const FIRST_SIDE: bool>(&mut self) {
        // One stage for all groups before the next: each is short enough that the processor has the next group's in sight.
        for group in &mut self.groups {
            group.blocks.take_off();
        }
        for group in &mut self.groups {
            group.blocks.land();
        }
        let mut any_unsure = false;
        for group in &mut self.groups {
            let (impact, unsure) = group.blocks.hit::<FIRST_SIDE>();
            any_unsure |= unsure;
            if let Some(place) = group.held.get_mut(self.count) {
                *place = impact;
            }
        }
        if any_unsure {
            self.alone(if FIRST_SIDE { -1.0 } else { 1.0 });
        } else {
            self.count += 1;
        }
        if self.count == self.room {
            self.write();
            self.finish();
        } else if self.count == HELD {
            self.write();
        }
    }

    /// Writes the impacts that are held.
    #[inline(never)]
    fn write(&mut self) {
        let count = self.count;
        for (group, places) in self.groups.iter().zip(self.places.chunks_exact_mut(L::COUNT)) {
            for (lane, place) in places.iter_mut().enumerate() {
                let Some(place) = place else { continue };
                let start = place.case * self.work.impacts + place.written;
                let [Some(time), Some(interval), Some(velocity)] =
                    self.rows.quantities().map(|row| row.get_mut(start..start + count))
                else {
                    continue;
                };
                let slots = time.iter_mut().zip(interval).zip(velocity);
                for (((time, interval), velocity), impact) in slots.zip(&group.held) {
                    *time = impact.time.lane(lane);
                    *interval = impact.interval.lane(lane);
                    *velocity = impact.velocity.lane(lane);
                }
                place.written += count;
            }
        }
        self.room = self.room.saturating_sub(count);
        self.count = 0;
    }

    /// Ends the cases that have all the impacts that are asked for.
    #[inline(never)]
    fn finish(&mut self) {
        for lane in 0..Self::LANES {
            let Some(Some(place)) = self.places.get(lane) else { continue };
            if place.written == self.work.impacts {
                let group = self.groups.get(lane / L::COUNT);
                let complete = group.is_some_and(|group| group.blocks.complete.lane(lane % L::COUNT) == 1.0);
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
        if let Some(group) = self.groups.get_mut(lane / L::COUNT) {
            group.blocks.busy.set_lane(lane % L::COUNT, 0.0);
        }
        if let Some(Place { case, written }) = self.places.get_mut(lane).and_then(Option::take) {
            self.free += 1;
            self.rows.end(case, Sequence { impacts: written, ending });
            self.tally.impacts += written as u64;
        }
    }

    /// The flights that the lanes are not sure of, by the scalar code; the others as they are. All are among the impacts that are held, but not counted yet.
    #[cold]
    #[inline(never)]
    fn alone(&mut self, sign: f64) {
        let mut last = [None; MOST_LANES];
        let mut gone = [None; MOST_LANES];
        for (lane, (last, gone)) in last.iter_mut().zip(&mut gone).enumerate().take(Self::LANES) {
            let Some(Group { blocks, held }) = self.groups.get_mut(lane / L::COUNT) else { continue };
            let lane = lane % L::COUNT;
            let zero = blocks.omega.splat(0.0);
            if zero.splat(1.0).select(blocks.unsure, zero).lane(lane) != 1.0 {
                continue;
            }
            self.tally.alone += 1;
            let mut single = Single::new(blocks, sign, lane);
            match single.fly() {
                Some(Finished { ending, listed: false }) => {
                    *gone = Some(ending);
                    continue;
                }
                Some(Finished { ending, .. }) => *last = Some(ending),
                None => {}
            }
            single.put_into(blocks, lane);
            if let Some(Impact { time, interval, velocity }) = held.get_mut(self.count) {
                for (place, value) in [time, interval, velocity].into_iter().zip(single.impact()) {
                    place.set_lane(lane, value);
                }
            }
        }
        // What has ended without this impact is gone before it is written.
        if gone.iter().any(Option::is_some) {
            let now = self.count;
            self.write();
            for group in &mut self.groups {
                if let Some(impact) = group.held.get(now).copied() {
                    group.held.fill(impact);
                }
            }
            self.end_all(gone);
        }
        self.count += 1;
        if last.iter().any(Option::is_some) {
            self.write();
            self.end_all(last);
        }
        self.measure();
    }

    fn end_all(&mut self, endings: [Option<Ending>; MOST_LANES]) {
        for (lane, ending) in endings.into_iter().enumerate() {
            if let Some(ending) = ending {
                self.end(lane, ending);
            }
        }
    }
}
