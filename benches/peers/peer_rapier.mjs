// Rapier (Rust, as WebAssembly from the npm registry, single precision): a rectangle on a floor that is shaken, as in block.py. And the protocol in JavaScript.
import RAPIER from "../../target/peers/node/node_modules/@dimforge/rapier2d-compat/dist/rapier.mjs";
import { createInterface } from "node:readline";

const STEPS = Number(process.env.STEPS ?? 20000); // of half a period
const ITERATIONS = Number(process.env.ITERATIONS ?? 20); // parts of a step
const FREQUENCY = 3e5; // of the springs that keep bodies apart
const FLOOR = process.env.FLOOR ?? "dynamic";
const LEAST = 3; // steps that a flight has to last in order to be listed

class Decline extends Error {
  constructor(reason, why) {
    super(why);
    this.refusal = { reason, why };
  }
}

/** The measures of the block: see block.py. */
function body({ alpha, eta }) {
  const [sine, cosine] = [Math.sin(alpha), Math.cos(alpha)];
  const aboutCorner = (2 * sine * sine) / (1 - eta);
  if (aboutCorner < 1.001) {
    throw new Decline("no such block", `1 - eta = ${1 - eta} of a block that neither slides nor bounces is below ${2 * sine * sine}`);
  }
  return { b: sine, h: cosine, inertia: aboutCorner - 1, gravity: aboutCorner, shake: aboutCorner * Math.tan(alpha) };
}

/** The angle and its rate after each step, under a shaking that is a function of time. */
function* states({ alpha, eta }, step, steps, shaking) {
  const { b, h, inertia, gravity, shake } = body({ alpha, eta });
  const world = new RAPIER.World({ x: 0, y: -gravity });
  try {
    world.timestep = step;
    world.integrationParameters.numSolverIterations = ITERATIONS;
    world.integrationParameters.contact_natural_frequency = FREQUENCY;
    // The centre of mass is the origin: single precision has most digits there. Contacts with fixed bodies are softer than the parameters say, so the
    // floor is a body that could move and is locked in every direction.
    const ground = FLOOR === "fixed" ? RAPIER.RigidBodyDesc.fixed() : RAPIER.RigidBodyDesc.dynamic().setGravityScale(0).setCanSleep(false);
    const base = world.createRigidBody(ground.setTranslation(0, -1 - h));
    base.lockTranslations(true, true);
    base.lockRotations(true, true);
    world.createCollider(RAPIER.ColliderDesc.cuboid(50, 1).setDensity(1e6).setFriction(100).setRestitution(0), base);
    const mass = RAPIER.RigidBodyDesc.dynamic().setAdditionalMassProperties(1, { x: 0, y: 0 }, inertia).setCanSleep(false);
    const block = world.createRigidBody(mass);
    world.createCollider(RAPIER.ColliderDesc.cuboid(b, h).setDensity(0).setFriction(100).setRestitution(0), block);
    for (let n = 0; n < steps; n++) {
      world.gravity = { x: -shake * shaking((n + 0.5) * step), y: -gravity };
      world.step();
      // Turning to the left is negative for the paper and positive for Rapier.
      yield [(n + 1) * step, -block.rotation() / alpha, -block.angvel() / alpha];
    }
  } finally {
    world.free();
  }
}

/** Flights that end where the rate stops growing towards the base, by at least half of what an impact takes: as by_rate() of block.py. */
function* flights({ eta }, step, row) {
  let [side, peak, when, height, before, landing] = [-1, 0, 0, 0, 0, null];
  for (const [now, phi, rate] of row) {
    const [closing, isUp] = [-side * rate, height > 0];
    if (isUp && closing > peak) [peak, when] = [closing, now];
    if (landing === null && isUp && peak > 0 && closing < 0.5 * (1 + eta) * peak) landing = when + 0.5 * step;
    let ended = null;
    if (landing !== null && Math.abs(rate - before) < 3 * step) {
      ended = [landing, before, height];
      [side, peak, height, landing] = [-side, 0, 0, null];
    }
    if (side * rate > 0) height = Math.max(height, Math.abs(phi));
    before = rate;
    yield [phi, ended];
  }
}

/** The impacts: as listed() of block.py. */
function listed(question) {
  const { epsilon, omega, impacts, until } = question;
  const [step, r] = [Math.PI / omega / STEPS, Math.sqrt(epsilon * (2 + epsilon))];
  const steps = until === "half-period" ? STEPS : Math.round(until / step);
  if (steps > 20 * STEPS) throw new Decline("too long", `${steps} steps`);
  let [give, isSeen, phi, ended] = [0, true, 0, null];
  for (const [, turned] of states(question, step, 200, () => 0.9)) give = Math.max(give, Math.abs(turned));
  const still = Math.max((LEAST * step) ** 2, 3 * give);
  let seen = [];
  const shaking = (time) => Math.cos(omega * time) + r * Math.sin(omega * time);
  for ([phi, ended] of flights(question, step, states(question, step, steps, shaking))) {
    if (!(Math.abs(phi) < 10)) break;
    if (ended === null || !isSeen) continue;
    isSeen = ended[0] - (seen.at(-1)?.[0] ?? 0) >= LEAST * step && Math.abs(ended[1]) > 0.1 * step;
    if (isSeen) seen.push(ended);
  }
  while (seen.length > 0 && seen.at(-1)[2] <= Math.max(3 * give, step ** 2)) seen.pop();
  seen = seen.slice(0, impacts);
  const columns = { time: seen.map(([time]) => time), velocity: seen.map(([, velocity]) => velocity) };
  if (seen.length === impacts) return { ...columns, ending: "limit-reached" };
  if (!(Math.abs(phi) < 10)) return { ...columns, ending: Number.isFinite(phi) ? "overturned" : "lost" };
  if (Math.abs(phi) > (isSeen ? still : 100 * still)) return { ...columns, ending: until === "half-period" ? "incomplete" : "limit-reached" };
  if (seen.length === 0) return { ...columns, ending: "lost", "x-why": "it never rocked" };
  return { ...columns, ending: "at-rest", tau_ch: seen.at(-1)[0], "x-give": give };
}

function answer(question) {
  if (question.model !== "nonlinear") return { decline: { reason: "another model", why: "a rigid block is not linear" } };
  if (question.epsilon <= 0) return { history: { time: [], velocity: [], ending: "never-rocks" } };
  const began = process.cpuUsage();
  try {
    const history = listed(question);
    const { user, system } = process.cpuUsage(began);
    return { history, ns: 1000 * (user + system) };
  } catch (error) {
    return error instanceof Decline ? { decline: error.refusal } : { error: { message: String(error) } };
  }
}

const ZERO = "minus zero"; // JSON.stringify drops the sign of -0
const keepSign = (_, value) => (Object.is(value, -0) ? ZERO : value);
const say = (message) => process.stdout.write(JSON.stringify(message, keepSign).replaceAll(`"${ZERO}"`, "-0.0") + "\n");

console.log = console.info = console.warn = console.error; // standard output is for answers only
await RAPIER.init();
for await (const line of createInterface({ input: process.stdin })) {
  const question = JSON.parse(line);
  if (question.cmd === "start") {
    const engine = { name: "Rapier", version: RAPIER.version(), language: "JavaScript" };
    say({ version: 1, engine, models: ["nonlinear"], normalisations: ["threshold"], ground: ["sine"], echo: question.echo });
  } else if (question.cmd === "case") say({ seq: question.seq, ...answer(question) });
  else break;
}
