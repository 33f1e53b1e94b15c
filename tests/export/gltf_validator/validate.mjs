// Reports on glTF files: one line of JSON, a list with the validator's report on each file that is named.
// The validator itself is installed in the current folder.
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";

const validator = createRequire(process.cwd() + "/")("gltf-validator");
const reports = [];
for (const path of process.argv.slice(2)) {
  const options = { maxIssues: 0, writeTimestamp: false };
  reports.push(await validator.validateBytes(new Uint8Array(readFileSync(path)), options));
}
console.log(JSON.stringify(reports));
